// Every folder of the house has a short README, and what READMEs name exists.
#include "unit/house/readme.h"

#include <gtest/gtest.h>

#include "unit/house/source_tree.h"

namespace lampyris::house {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMaxLines = 60;

std::vector<std::string> houseFolders() {
    std::vector<std::string> folders = {"shaders", "sandbox", "sandbox/courtyard", "tests"};
    for (const char* room : {"engine", "modules"})
        for (const auto& entry : fs::directory_iterator(root() / room))
            if (entry.is_directory())
                folders.push_back(entry.path().lexically_relative(root()).generic_string());
    std::sort(folders.begin(), folders.end());
    return folders;
}

// Where a README may mean its paths to start: at itself, at the top, or at an include root.
bool exists(const std::string& readme, const std::string& claim) {
    const fs::path folder = fs::path(readme).parent_path();
    for (const fs::path& base : {folder, fs::path("."), fs::path("engine"), fs::path("modules"),
                                 fs::path("shaders"), fs::path("tests")}) {
        const fs::path path = (base / claim).lexically_normal();
        const bool within = path.empty() || *path.begin() != "..";
        if (within && fs::exists(root() / path)) return true;
    }
    return false;
}

TEST(Readme, StandsInEachFolderAndIsShort) {
    for (const std::string& folder : houseFolders()) {
        const fs::path path = root() / folder / "README.md";
        if (!fs::exists(path)) {
            ADD_FAILURE() << folder << " has no README.md";
            continue;
        }
        const std::string text = textOf(folder + "/README.md");
        const auto lines = static_cast<size_t>(std::count(text.begin(), text.end(), '\n'));
        EXPECT_LE(lines, kMaxLines) << folder << "/README.md";
        EXPECT_GT(lines, 5u) << folder << "/README.md says nothing";
    }
}

TEST(Readme, NamesOnlyPathsThatExist) {
    std::vector<std::string> readmes =
        filesBelow({"engine", "modules", "shaders", "sandbox", "tests", "cmake"}, {".md"});
    for (const char* name : {"README.md", "CONTRIBUTING.md"})
        if (fs::exists(root() / name)) readmes.emplace_back(name);
    ASSERT_FALSE(readmes.empty());
    for (const std::string& readme : readmes)
        for (const PathClaim& claim : pathClaims(textOf(readme)))
            EXPECT_TRUE(exists(readme, claim.path))
                << readme << ":" << claim.line << ": " << claim.path;
}

std::vector<std::string> claimed(std::string_view text) {
    std::vector<std::string> paths;
    for (const PathClaim& claim : pathClaims(text)) paths.push_back(claim.path);
    return paths;
}

TEST(Readme, ClaimsAreFound) {
    EXPECT_EQ(
        claimed(
            "Open `frame.cpp`, then `photon_gi/tile_bin.comp` and [here](../core/README.md#why)."),
        (std::vector<std::string>{"frame.cpp", "photon_gi/tile_bin.comp", "../core/README.md"}));
    EXPECT_EQ(claimed("`engine/scene` `systems/` `tile_bin.h/.cpp` `world.h:12`"),
              (std::vector<std::string>{"engine/scene", "systems/", "tile_bin.h", "world.h"}));
    EXPECT_EQ(pathClaims("one\ntwo `a.h`").at(0).line, 2);
}

TEST(Readme, OtherThingsClaimNothing) {
    EXPECT_EQ(claimed("`bash sandbox/run.sh` `W/m²` `W/m` `1/255` `*.comp` `<module>/a.h` "
                      "`out/a.md` `build/x/`"),
              std::vector<std::string>{});
    EXPECT_EQ(
        claimed(
            "[site](https://example.org/a.h) `https://example.org/a.h` `--output-node` `.h` `/`"),
        std::vector<std::string>{});
    EXPECT_EQ(claimed("```cpp\n#include `not/here.h`\n```\n"), std::vector<std::string>{});
}

TEST(Readme, AMissingPathIsNoticed) {
    EXPECT_TRUE(exists("engine/core/README.md", "result.h"));
    EXPECT_TRUE(exists("engine/core/README.md", "engine/core"));
    EXPECT_FALSE(exists("engine/core/README.md", "no_such_file.h"));
    EXPECT_FALSE(exists("engine/core/README.md", "../../../"));
}

}  // namespace
}  // namespace lampyris::house
