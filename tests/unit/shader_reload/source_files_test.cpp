// Which shaders a changed file concerns.
#include "shader_reload/source_files.h"

#include <gtest/gtest.h>

#include <optional>

#include "core/file.h"
#include "unit/core/scratch_folder.h"

namespace lampyris::shader_reload {
namespace {

using Names = std::set<std::string>;

class SourceFilesTest : public testing::Test {
 protected:
    void write(const std::string& file, const std::string& text) {
        std::filesystem::create_directories((folder_ / file).parent_path());
        ASSERT_TRUE(core::writeFile(folder_ / file, text).ok());
    }
    void SetUp() override {
        write("a.comp", "#include \"lib/x.glsl\"\n");
        write("b.comp", "  #  include \"lib/y.glsl\" // why\n");
        write("c.comp", "// #include \"lib/x.glsl\"\n");
        write("lib/x.glsl", "#include \"lib/y.glsl\"\n");
        write("lib/y.glsl", "int y;\n");
        files_.emplace(folder_ / "");
        for (const char* file : {"a.comp", "b.comp", "c.comp"}) files_->follow(file);
    }
    core::ScratchFolder folder_;
    std::optional<SourceFiles> files_;
};

TEST_F(SourceFilesTest, NothingChangedAtFirst) {
    EXPECT_EQ(files_->changed(), Names{});
}

TEST_F(SourceFilesTest, AFileConcernsAllThatIncludeIt) {
    write("a.comp", "#include \"lib/x.glsl\"\nint a;\n");
    EXPECT_EQ(files_->changed(), Names{"a.comp"});
    EXPECT_EQ(files_->changed(), Names{});
    write("lib/x.glsl", "#include \"lib/y.glsl\"\nint x;\n");
    EXPECT_EQ(files_->changed(), Names{"a.comp"});
    write("lib/y.glsl", "float y;\n");
    EXPECT_EQ(files_->changed(), (Names{"a.comp", "b.comp"}));
}

TEST_F(SourceFilesTest, ATextOfTheSameSizeShowsByItsTime) {
    write("c.comp", "// #include \"lib/z.glsl\"\n");
    const auto later =
        std::filesystem::last_write_time(folder_ / "c.comp") + std::chrono::seconds(1);
    std::filesystem::last_write_time(folder_ / "c.comp", later);
    EXPECT_EQ(files_->changed(), Names{"c.comp"});
}

TEST_F(SourceFilesTest, FilesThatComeAndGo) {
    std::filesystem::remove(folder_ / "lib/x.glsl");
    EXPECT_EQ(files_->changed(), Names{"a.comp"});
    EXPECT_EQ(files_->changed(), Names{});
    write("lib/x.glsl", "int x;\n");
    EXPECT_EQ(files_->changed(), Names{"a.comp"});
    write("lib/y.glsl", "float y;\n");  // which x no longer includes
    EXPECT_EQ(files_->changed(), Names{"b.comp"});
}

TEST_F(SourceFilesTest, WhatWasWrittenBeforeItIsFollowedIsSeen) {
    write("d.comp", "#include \"lib/y.glsl\"\n");
    const auto later =
        std::filesystem::last_write_time(folder_ / "d.comp") + std::chrono::seconds(1);
    std::filesystem::last_write_time(folder_ / "d.comp", later);
    files_->follow("d.comp");
    EXPECT_EQ(files_->changed(), Names{"d.comp"});
    EXPECT_EQ(files_->changed(), Names{});
}

TEST_F(SourceFilesTest, IncludesThatWereAddedAreFollowed) {
    write("c.comp", "#include \"lib/new.glsl\"\n");
    EXPECT_EQ(files_->changed(), Names{"c.comp"});
    write("lib/new.glsl", "#include \"lib/new.glsl\"\n");
    EXPECT_EQ(files_->changed(), Names{"c.comp"});
}

}  // namespace
}  // namespace lampyris::shader_reload
