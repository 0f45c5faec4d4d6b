// Past 500 lines a file is split; and no folder is a drawer for everything.
#include <gtest/gtest.h>

#include "unit/house/source_tree.h"

namespace lampyris::house {
namespace {

constexpr std::ptrdiff_t kMaxLines = 500;

const std::vector<std::string> kTop = {"engine", "modules", "shaders", "sandbox",
                                       "tests",  "cmake",   ".ci"};

TEST(Sizes, NoSourceFileIsOver500Lines) {
    const auto files = filesBelow(
        kTop, {".h", ".cpp", ".comp", ".vert", ".frag", ".glsl", ".cmake", ".txt", ".sh", ".py"});
    ASSERT_GT(files.size(), 50u);
    for (const std::string& file : files) {
        const std::string text = textOf(file);
        EXPECT_LE(std::count(text.begin(), text.end(), '\n'), kMaxLines) << file;
    }
}

TEST(Names, NoFolderIsADrawer) {
    const std::vector<std::string> drawers = {"old",    "misc",    "utils",    "util",
                                              "common", "manager", "managers", "helpers"};
    for (const std::string& file : filesBelow(kTop, {""}))
        for (const auto& part : std::filesystem::path(file).parent_path())
            EXPECT_EQ(std::count(drawers.begin(), drawers.end(), part.string()), 0) << file;
}

}  // namespace
}  // namespace lampyris::house
