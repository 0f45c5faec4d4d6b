// The compiler within the program is the build's: the same words, and errors that name the place.
#include "shader_reload/compile_shader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "core/file.h"
#include "deferred/shaders.h"
#include "graph/shader.h"
#include "photon_gi/shaders.h"
#include "photons/shaders.h"
#include "unit/core/scratch_folder.h"

namespace lampyris::shader_reload {
namespace {

void write(const std::filesystem::path& path, const std::string& text) {
    std::filesystem::create_directories(path.parent_path());
    ASSERT_TRUE(core::writeFile(path, text).ok());
}

core::Result<std::vector<uint32_t>> compileIn(const core::ScratchFolder& folder) {
    return compileShader({folder / "", "a.comp"});
}

std::string errorOf(const core::Result<std::vector<uint32_t>>& result) {
    return result.ok() ? "no error" : result.error().message;
}

const std::string kHead =
    "#version 460\n"
    "#extension GL_GOOGLE_include_directive : require\n"
    "layout(local_size_x = 1) in;\n";

TEST(CompileShader, GivesTheWordsOfTheBuild) {
    const graph::Shader* const shaders[] = {
        &deferred::shaders::gbufferVert,     &deferred::shaders::gbufferFrag,
        &photons::shaders::photonTrace,      &photon_gi::shaders::tileBinPairs,
        &photon_gi::shaders::tileBinCount,   &photon_gi::shaders::finalGather,
        &photon_gi::shaders::finalHistory,   &photon_gi::shaders::finalHistoryMoving,
        &photon_gi::shaders::compositeDirect};
    for (const graph::Shader* shader : shaders) {
        ShaderSource source{LAMPYRIS_SOURCE_DIR "/shaders", std::string{shader->source}};
        source.definitions.assign(shader->definitions.begin(), shader->definitions.end());
        const auto words = compileShader(source);
        ASSERT_TRUE(words.ok()) << shader->name << ": " << errorOf(words);
        EXPECT_TRUE(std::ranges::equal(*words, shader->words)) << shader->name;
    }
}

TEST(CompileShader, AnErrorNamesFileAndLine) {
    const core::ScratchFolder folder;
    write(folder / "a.comp", kHead + "void main() {\n    int i = nothing;\n}\n");
    EXPECT_TRUE(errorOf(compileIn(folder)).starts_with("a.comp:5: 'nothing' : undeclared"))
        << errorOf(compileIn(folder));
    write(folder / "lib/b.glsl", "\nint b() { return 1 }\n");
    write(folder / "a.comp", kHead + "#include \"lib/b.glsl\"\nvoid main() { b(); }\n");
    EXPECT_TRUE(errorOf(compileIn(folder)).starts_with("lib/b.glsl:2: "))
        << errorOf(compileIn(folder));
    EXPECT_EQ(errorOf(compileIn(folder)).find('\n'), std::string::npos);
}

TEST(CompileShader, IncludesAreFoundBesideAndFromTheFolder) {
    const core::ScratchFolder folder;
    write(folder / "lib/b.glsl", "#include \"c.glsl\"\n#include \"other/d.glsl\"\n");
    write(folder / "lib/c.glsl", "int c() { return 1; }\n");
    write(folder / "other/d.glsl", "int d() { return 2; }\n");
    write(folder / "a.comp", kHead + "#include \"lib/b.glsl\"\nvoid main() { c(); d(); }\n");
    EXPECT_TRUE(compileIn(folder).ok()) << errorOf(compileIn(folder));
}

TEST(CompileShader, WhatIsMissingOrEndlessIsAnError) {
    const core::ScratchFolder folder;
    EXPECT_NE(errorOf(compileIn(folder)).find("a.comp: cannot be read"), std::string::npos);
    write(folder / "a.comp", kHead + "#include \"lib/b.glsl\"\nvoid main() {}\n");
    EXPECT_TRUE(errorOf(compileIn(folder)).starts_with("a.comp:4: ")) << errorOf(compileIn(folder));
    write(folder / "lib/b.glsl", "#include \"lib/b.glsl\"\n");
    EXPECT_TRUE(errorOf(compileIn(folder)).starts_with("lib/b.glsl:1: "))
        << errorOf(compileIn(folder));
    write(folder / "a.comp", "");
    EXPECT_TRUE(errorOf(compileIn(folder)).starts_with("a.comp")) << errorOf(compileIn(folder));
    EXPECT_TRUE(errorOf(compileShader({folder / "", "lib/b.glsl"})).starts_with("lib/b.glsl: "));
}

TEST(CompileShader, WhatIncludesItselfManyTimesEndsSoon) {
    const core::ScratchFolder folder;
    write(folder / "a.comp", kHead + "#include \"lib/b.glsl\"\nvoid main() {}\n");
    write(folder / "lib/b.glsl", "#include \"lib/b.glsl\"\n#include \"lib/b.glsl\"\n");
    const auto begin = std::chrono::steady_clock::now();
    const std::string error = errorOf(compileIn(folder));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
    EXPECT_NE(error.find("lib/b.glsl:1: "), std::string::npos) << error;
    EXPECT_NE(error.find("does a file include itself?"), std::string::npos) << error;
    std::string many = kHead;
    for (int i = 0; i < 1001; ++i) many += "#include \"lib/c.glsl\"\n";
    write(folder / "lib/c.glsl", "\n");
    write(folder / "a.comp", many + "void main() {}\n");
    EXPECT_TRUE(errorOf(compileIn(folder)).starts_with("a.comp:1004: "))
        << errorOf(compileIn(folder));
}

TEST(CompileShader, TakesDefinitions) {
    const core::ScratchFolder folder;
    write(folder / "a.comp",
          kHead + "#ifndef SWITCH\n#error no switch\n#endif\nvoid main() { int i = VALUE; }\n");
    EXPECT_TRUE(errorOf(compileIn(folder)).starts_with("a.comp:5: ")) << errorOf(compileIn(folder));
    EXPECT_TRUE(compileShader({folder / "", "a.comp", {"SWITCH", "VALUE=3"}}).ok());
}

}  // namespace
}  // namespace lampyris::shader_reload
