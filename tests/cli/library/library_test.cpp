// The library as a game meets it: installed, found by CMake and by pkg-config, in a folder outside
// of the sources.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "cli/program/program.h"
#include "core/image_io.h"

namespace lampyris::test {
namespace {

namespace fs = std::filesystem;

const std::string kMinimal = LAMPYRIS_SOURCE_DIR "/sandbox/minimal";
const std::string kCompilerOption = "-DCMAKE_CXX_COMPILER=" + std::string(LAMPYRIS_CXX);
constexpr std::string_view kSanitize = LAMPYRIS_SANITIZE;  // NOLINT: may be empty

std::vector<std::string> compilerFlags() {
    std::vector<std::string> flags{"-Wall", "-Wextra", "-Wpedantic", "-Werror"};
    if (!kSanitize.empty()) flags.push_back("-fsanitize=" + std::string(kSanitize));
    return flags;
}

void succeed(const Arguments& command) {
    const Ran ran = run(command);
    ASSERT_EQ(ran.code, 0) << testing::PrintToString(command) << "\n" << ran.out << ran.err;
}

core::DisplayImage pictureOf(const fs::path& path) {
    const auto picture = core::readPng(path);
    EXPECT_TRUE(picture.ok()) << picture.error().message;
    return picture.ok() ? *picture : core::DisplayImage{};
}

/// Mean difference of two pictures, 0 to 255.
double difference(const core::DisplayImage& a, const core::DisplayImage& b) {
    EXPECT_EQ(a.values.size(), b.values.size());
    double sum = 0.0;
    for (size_t i = 0; i < std::min(a.values.size(), b.values.size()); ++i)
        sum += std::abs(a.values[i] - b.values[i]);
    return sum / static_cast<double>(std::max<size_t>(a.values.size(), 1));
}

/// The share of values that are lit and not blown out.
double litShare(const core::DisplayImage& picture) {
    const auto lit = std::count_if(picture.values.begin(), picture.values.end(),
                                   [](uint8_t value) { return value > 20 && value < 255; });
    return static_cast<double>(lit) / static_cast<double>(picture.values.size());
}

class Library : public testing::Test {
 protected:
    /// Installed somewhere, then moved: nothing may remember where it was.
    void SetUp() override {
        const fs::path elsewhere = scratch_ / "elsewhere";
        succeed({LAMPYRIS_CMAKE, "--install", LAMPYRIS_BINARY_DIR, "--prefix", elsewhere});
        ASSERT_TRUE(fs::exists(elsewhere / "bin/lampyris"));
        ASSERT_TRUE(fs::exists(elsewhere / "share/doc/lampyris/LICENSE"));
        fs::rename(elsewhere, prefix_);
    }

    /// Frame `first` and frame `later` of an example: lit both, and not the same.
    void expectLitAndMoving(const std::string& example, int later) const {
        const auto draw = [&](int frames) {
            const fs::path path = scratch_ / (example + std::to_string(frames) + ".png");
            succeed({game_ / ("build/" + example), path, std::to_string(frames)});
            return pictureOf(path);
        };
        const core::DisplayImage before = draw(1);
        const core::DisplayImage after = draw(later);
        EXPECT_GT(litShare(before), 0.2) << example;
        EXPECT_GT(litShare(after), 0.2) << example;
        EXPECT_GT(difference(before, after), 0.5) << example << " stands still";
    }

    /// Of one file, without CMake.
    [[nodiscard]] Arguments compilation(const std::string& source, const Arguments& more) const {
        const std::string path = "PKG_CONFIG_PATH=" + (prefix_ / "lib/pkgconfig").string();
        const Ran found = run({"pkg-config", "--cflags", "--libs", "--static", "lampyris"}, {path});
        EXPECT_EQ(found.code, 0) << found.err;
        Arguments command{LAMPYRIS_CXX, "-std=c++20", source};
        command.insert(command.end(), more.begin(), more.end());
        for (const std::string& flag : compilerFlags()) command.push_back(flag);
        std::istringstream words(found.out);
        for (std::string word; words >> word;) command.push_back(word);
        return command;
    }

    /// A game of these lines alone.
    [[nodiscard]] Ran configure(const std::string& lines) const {
        fs::create_directories(game_);
        std::ofstream(game_ / "CMakeLists.txt")
            << "cmake_minimum_required(VERSION 3.25)\nproject(game LANGUAGES CXX)\n"
            << lines;
        return run({LAMPYRIS_CMAKE, "-G", "Ninja", "-S", game_, "-B", game_ / "build",
                    "-DCMAKE_PREFIX_PATH=" + prefix_.string(), kCompilerOption});
    }

    ScratchFolder scratch_;
    fs::path prefix_ = scratch_ / "prefix";
    fs::path game_ = scratch_ / "game";
};

TEST_F(Library, IsFoundByCMakeAndDrawsForAGame) {
    fs::copy(kMinimal, game_);
    std::ostringstream flags;
    for (const std::string& flag : compilerFlags()) flags << flag << " ";
    succeed({LAMPYRIS_CMAKE, "-G", "Ninja", "-S", game_, "-B", game_ / "build",
             "-DCMAKE_PREFIX_PATH=" + prefix_.string(), kCompilerOption,
             "-DCMAKE_CXX_FLAGS=" + flags.str()});
    succeed({LAMPYRIS_CMAKE, "--build", game_ / "build"});
    expectLitAndMoving("minimal", 8);
    expectLitAndMoving("own_storage", 8);

    // On the game's own device the picture is the program's.
    const fs::path own = scratch_ / "own_device.png";
    const fs::path ours = scratch_ / "ours.png";
    succeed({game_ / "build/own_device", own});
    succeed({prefix_ / "bin/lampyris", "render", "cornell", "-o", ours, "--exposure", "-1"});
    EXPECT_EQ(difference(pictureOf(own), pictureOf(ours)), 0.0);
}

TEST(Minimal, IsNotLongerThanPromised) {
    EXPECT_LE(std::ranges::count(textOf(kMinimal + "/main.cpp"), '\n'), 60);
}

TEST_F(Library, SaysWhichFolderIsNotThere) {
    const Ran ran =
        configure("find_package(lampyris 0.1 CONFIG REQUIRED COMPONENTS ecs no_such_folder)\n");
    EXPECT_NE(ran.code, 0);
    EXPECT_NE(ran.err.find("no_such_folder"), std::string::npos) << ran.err;
}

// Before 1.0 another minor version is another library.
TEST_F(Library, IsNoOtherMinorVersion) {
    const Ran ran = configure("find_package(lampyris 0.0.9 CONFIG REQUIRED)\n");
    EXPECT_NE(ran.code, 0);
    EXPECT_NE(ran.err.find("0.0.9"), std::string::npos) << ran.err;
}

TEST_F(Library, LeavesAGamesVariablesAsTheyAre) {
    const Ran ran = configure(
        "set(libraries mine)\nset(missing mine)\nset(name mine)\n"
        "find_package(lampyris 0.1 CONFIG REQUIRED)\n"
        "if(NOT \"${libraries} ${missing} ${name}\" STREQUAL \"mine mine mine\")\n"
        "  message(FATAL_ERROR \"${libraries} ${missing} ${name}\")\nendif()\n");
    EXPECT_EQ(ran.code, 0) << ran.err;
}

TEST_F(Library, IsFoundByPkgConfig) {
    succeed(compilation(kMinimal + "/main.cpp", {"-o", scratch_ / "game"}));
    const fs::path picture = scratch_ / "picture.png";
    succeed({scratch_ / "game", picture, "1"});
    EXPECT_GT(litShare(pictureOf(picture)), 0.2);
}

// Each archive whole, in its place: what it needs stands behind it.
TEST_F(Library, HasItsArchivesInTheOrderOfTheirNeeds) {
    const fs::path source = scratch_ / "empty.cpp";
    std::ofstream(source) << "int main() {}\n";
    const Arguments all = compilation(source, {"-o", scratch_ / "empty"});
    size_t archives = 0;
    for (size_t i = 0; i < all.size(); ++i) {
        if (!all[i].starts_with("-llampyris_")) continue;
        Arguments command = all;
        command[i] = "-Wl,--whole-archive," + all[i] + ",--no-whole-archive";
        succeed(command);
        ++archives;
    }
    EXPECT_GT(archives, 15u);
}

TEST_F(Library, HasEveryHeaderThatItsHeadersInclude) {
    const fs::path headers = prefix_ / "include/lampyris";
    std::ofstream all(scratch_ / "all.cpp");
    const auto ownPlace = [](const fs::path& name) {
        return name == "world_inline.h" || name == "check.h";
    };
    for (const auto& entry : fs::recursive_directory_iterator(headers))
        if (entry.is_regular_file() && !ownPlace(entry.path().filename()))
            all << "#include \"" << entry.path().lexically_relative(headers).string() << "\"\n";
    all << "#ifdef CHECK\n#error \"doctest, Catch2 and glog have a CHECK of their own\"\n#endif\n"
        << "#include \"core/check.h\"\n";
    all.close();
    succeed(compilation(scratch_ / "all.cpp", {"-fsyntax-only"}));
}

}  // namespace
}  // namespace lampyris::test
