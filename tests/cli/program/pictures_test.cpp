// sandbox/pictures.sh: the root README's pictures and table, in a small house of the test's own.
#include <algorithm>
#include <fstream>

#include "cli/program/program.h"

namespace lampyris::test {
namespace {

namespace fs = std::filesystem;

const std::string kReadme =
    "# Title\n"
    "<!-- sandbox/pictures.sh writes from here -->\n"
    "an old table\n"
    "<!-- to here -->\n"
    "The end.\n";
const std::vector<std::string> kPictures{"cornell_full.png",        "cornell_reference.png",
                                         "cornell_thesis.png",      "two_rooms_full.png",
                                         "two_rooms_reference.png", "two_rooms_thesis.png"};

/// A folder with the script, the program as it was built, and a set-up that has nothing to do.
class Pictures : public testing::Test {
 protected:
    void SetUp() override {
        fs::create_directories(root_ / "sandbox/pictures");
        fs::create_directories(root_ / "build/release/sandbox");
        fs::create_symlink(programPath(), root_ / "build/release/sandbox/lampyris");
        fs::copy(LAMPYRIS_SOURCE_DIR "/sandbox/pictures.sh", root_ / "sandbox/pictures.sh");
        std::ofstream(root_ / "sandbox/setup.sh") << "root=" << root_.string() << "\n"
                                                  << "installMissing() { :; }\n"
                                                  << "build() { :; }\n";
        write(kReadme);
    }

    void write(const std::string& readme) { std::ofstream(root_ / "README.md") << readme; }
    [[nodiscard]] std::string readme() const { return textOf(root_ / "README.md"); }
    [[nodiscard]] Ran make(const std::string& samples) const {
        return run({"bash", root_ / "sandbox/pictures.sh", "64x36", samples});
    }
    [[nodiscard]] std::vector<std::string> pictures() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(root_ / "sandbox/pictures"))
            names.push_back(entry.path().filename());
        std::sort(names.begin(), names.end());
        return names;
    }

    void expectUntouched(const Ran& ran, const std::string& before, const std::string& what) const {
        EXPECT_EQ(ran.code, 1) << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
        EXPECT_NE(ran.err.find(what), std::string::npos) << ran.err;
        EXPECT_EQ(readme(), before);
        EXPECT_TRUE(pictures().empty()) << testing::PrintToString(pictures());
        EXPECT_TRUE(!fs::exists(root_ / "out/pictures") || fs::is_empty(root_ / "out/pictures"));
    }

    ScratchFolder scratch_;
    fs::path root_ = scratch_ / "house";
};

TEST_F(Pictures, StandInTheReadmeWithTheirFigures) {
    const Ran ran = make("2");
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    EXPECT_EQ(pictures(), kPictures);
    const std::string text = readme();
    for (const std::string& picture : kPictures)
        EXPECT_NE(text.find("(sandbox/pictures/" + picture + ")"), std::string::npos) << text;
    EXPECT_EQ(text.find("an old table"), std::string::npos);
    EXPECT_EQ(text.find("# Title\n<!-- sandbox/pictures.sh"), 0u) << "what stands before stays";
    EXPECT_NE(text.find("\n<!-- to here -->\nThe end.\n"), std::string::npos) << text;
    for (const char* figure : {" ms, ", " s |", "MSE / MSSIM ", "64x36", "2 samples a pixel"})
        EXPECT_NE(text.find(figure), std::string::npos) << figure << "\n" << text;
    EXPECT_EQ(text.find("| 0 ms"), std::string::npos) << "a time was not found\n" << text;
    EXPECT_EQ(text.find("MSSIM 0.0 / "), std::string::npos) << "an error was not found\n" << text;

    // Again: the references are there, and the old table makes way.
    const Ran again = make("2");
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_NE(ran.out.find("cornell: reference"), std::string::npos) << ran.out;
    EXPECT_EQ(again.out.find("cornell: reference"), std::string::npos) << again.out;
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), std::ranges::count(readme(), '\n'));
}

TEST_F(Pictures, AFailureChangesNothing) {
    expectUntouched(make("0"), kReadme, "--spp 0");
    const std::string unmarked = "# Title\nThe end.\n";
    write(unmarked);
    expectUntouched(make("2"), unmarked, "README.md must hold the line");
    write(kReadme + kReadme);
    expectUntouched(make("2"), kReadme + kReadme, "README.md must hold the line");
}

}  // namespace
}  // namespace lampyris::test
