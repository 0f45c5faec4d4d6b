// A node's shader is edited, broken and mended while frames go on.
#include "shader_reload/shader_reloader.h"

#include <array>
#include <fstream>
#include <iostream>
#include <thread>

#include "core/file.h"
#include "gpu/execute/execute_test.h"
#include "unit/core/scratch_folder.h"

namespace lampyris {
namespace {

using shader_reload::ShaderReloader;
using shader_reload::ShaderState;
using shader_reload::ShaderStatus;
using Clock = std::chrono::steady_clock;
namespace shaders = gpu_test::shaders;

constexpr auto kLongest = std::chrono::seconds(20);
constexpr uint32_t kCount = 64;

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
}

class ReloadTest : public test::ExecuteTest {
 protected:
    void SetUp() override {
        ExecuteTest::SetUp();
        if (IsSkipped()) return;
        for (const char* file : {"doubled.comp", "count.comp", "triangle.vert", "triangle.frag"})
            write(file, original(file));
        source_ = makeBuffer(std::vector<uint32_t>(kCount, 5));
    }
    void TearDown() override {
        source_ = {};
        ExecuteTest::TearDown();
    }
    static std::string original(const std::string& file) {
        const auto bytes = test::need(
            core::readFile(std::filesystem::path(LAMPYRIS_SOURCE_DIR "/tests/gpu/shaders") / file));
        return {bytes.begin(), bytes.end()};
    }
    void write(const std::string& file, const std::string& text) {
        test::need(core::writeFile(folder_ / file, text));
    }
    /// 2 · 5 + add, by the shader as it was built.
    uint32_t runDoubled(uint32_t add = 1) {
        graph::Frame frame;
        const auto out = test::addDouble(frame, "double", import(frame, source_), kCount, add);
        frame.output(out);
        return test::valuesOf<uint32_t>(run(frame, {.readBackBuffers = {out}}).buffers[0])[7];
    }
    /// How often 64 · groups threads count, by the shader as it was built.
    uint32_t runCount() {
        graph::Frame frame;
        auto clear = frame.transfer("clear");
        auto counter = clear.fill(frame.buffer("counter", {4}), 0);
        auto node = frame.compute("count", shaders::count);
        counter = node.update(0, counter);
        node.dispatch(1);
        frame.output(counter);
        return test::valuesOf<uint32_t>(run(frame, {.readBackBuffers = {counter}}).buffers[0])[0];
    }
    ShaderReloader watch() {
        auto reloader = test::need(ShaderReloader::create(folder_ / ""));
        EXPECT_TRUE(reloader.update(executor()).empty());  // follows what has run
        return reloader;
    }
    /// Frames go on until something came of the last edit.
    std::vector<ShaderStatus> wait(ShaderReloader& reloader) {
        const auto end = Clock::now() + kLongest;
        while (Clock::now() < end) {
            auto settled = reloader.update(executor());
            if (!settled.empty()) return settled;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        ADD_FAILURE() << "nothing came of the edit";
        return {{}};
    }

    core::ScratchFolder folder_;
    gpu::Buffer source_;
};

TEST_F(ReloadTest, AnEditIsSeenInTheNextFrameAndABrokenFileIsNot) {
    EXPECT_EQ(runDoubled(), 11u);
    ShaderReloader reloader = watch();
    const std::string text = original("doubled.comp");
    const auto saved = Clock::now();
    write("doubled.comp", replaced(text, "2u *", "3u *"));
    auto settled = wait(reloader);
    EXPECT_EQ(runDoubled(), 16u);
    const std::chrono::duration<double> taken = Clock::now() - saved;
    std::cout << "one shader, from saving to the end of the first frame: " << taken.count() * 1e3
              << " ms, of them from noticing " << settled[0].milliseconds << " ms\n";
    EXPECT_LT(taken.count(), 1.5);
    ASSERT_EQ(settled.size(), 1u);
    EXPECT_EQ(settled[0].name, "gpu_test/doubled.comp");
    EXPECT_EQ(settled[0].state, ShaderState::Ok);
    EXPECT_EQ(settled[0].reloads, 1u);

    write("doubled.comp", replaced(text, "2u *", "4u * nothing *"));
    settled = wait(reloader);
    EXPECT_EQ(settled[0].state, ShaderState::Broken);
    EXPECT_TRUE(settled[0].error.starts_with("doubled.comp:9: 'nothing' : undeclared"))
        << settled[0].error;
    EXPECT_EQ(runDoubled(), 16u);

    write("doubled.comp", text);
    settled = wait(reloader);
    EXPECT_EQ(settled[0].state, ShaderState::Ok);
    EXPECT_EQ(settled[0].error, "");
    EXPECT_EQ(settled[0].reloads, 2u);
    EXPECT_EQ(runDoubled(), 11u);
}

TEST_F(ReloadTest, AnotherInterfaceNamesItsSlotAndIsNotRun) {
    runDoubled();
    ShaderReloader reloader = watch();
    const std::string text = original("doubled.comp");
    const std::array<std::array<std::string, 3>, 6> edits{{
        {"binding = 0", "binding = 5", "doubled.comp: slot 0 (source) is gone"},
        {"readonly buffer In", "buffer In", "doubled.comp: slot 0 (source) is read and written"},
        {"void main", "layout(binding = 3) uniform U { float u; } extra;\nvoid main",
         "doubled.comp: slot 3 (extra) is new"},
        {"readonly buffer In { uint values[]; }", "uniform In { uint values[4]; }",
         "doubled.comp: slot 0 (source) is a UniformBuffer"},
        {"local_size_x = 64", "local_size_x = 32", "doubled.comp: its workgroup is 32x1x1"},
        {"uint add;", "uint add; uint more;", "doubled.comp: it takes 12 bytes of push constants"},
    }};
    for (const auto& [what, by, error] : edits) {
        write("doubled.comp", replaced(text, what, by));
        const auto settled = wait(reloader);
        EXPECT_EQ(settled[0].state, ShaderState::Broken);
        EXPECT_TRUE(settled[0].error.starts_with(error)) << settled[0].error;
        EXPECT_EQ(settled[0].reloads, 0u);
        EXPECT_EQ(runDoubled(), 11u);
    }
}

/// A shader's text that includes shared.glsl.
std::string including(const std::string& text) {
    return replaced(text, "#version 460\n",
                    "#version 460\n#extension GL_GOOGLE_include_directive : require\n"
                    "#include \"shared.glsl\"\n");
}

TEST_F(ReloadTest, AnIncludeReloadsAllThatUseIt) {
    write("shared.glsl", "const uint kFactor = 2u;\n");
    write("doubled.comp", including(replaced(original("doubled.comp"), "2u", "kFactor")));
    write("count.comp", including(replaced(original("count.comp"), ", 1u)", ", kFactor - 1u)")));
    const uint32_t counted = runCount();
    EXPECT_EQ(runDoubled(), 11u);
    ShaderReloader reloader = watch();
    write("shared.glsl", "const uint kFactor = 3u;\n");
    const auto settled = wait(reloader);
    EXPECT_EQ(settled.size(), 2u);
    for (const ShaderStatus& status : settled) EXPECT_EQ(status.state, ShaderState::Ok);
    EXPECT_EQ(runDoubled(), 16u);
    EXPECT_EQ(runCount(), 2 * counted);

    write("shared.glsl", "const uint kFactor = ;\n");
    for (const ShaderStatus& status : wait(reloader)) {
        EXPECT_EQ(status.state, ShaderState::Broken);
        EXPECT_TRUE(status.error.starts_with("shared.glsl:1: ")) << status.error;
    }
    EXPECT_EQ(runDoubled(), 16u);
    EXPECT_EQ(reloader.status().size(), 2u);
}

TEST_F(ReloadTest, WhatChangedTogetherGoesInTogetherOrNotAtAll) {
    write("shared.glsl", "const uint kFactor = 2u;\nconst uint kStep = 1u;\n");
    write("doubled.comp", including(replaced(original("doubled.comp"), "2u", "kFactor")));
    const std::string count = including(replaced(original("count.comp"), ", 1u)", ", kStep)"));
    write("count.comp", count);
    const uint32_t counted = runCount();
    EXPECT_EQ(runDoubled(), 11u);
    ShaderReloader reloader = watch();
    write("shared.glsl", "const uint kFactor = 3u;\n");
    auto settled = wait(reloader);
    ASSERT_EQ(settled.size(), 1u);
    EXPECT_EQ(settled[0].name, "gpu_test/count.comp");
    EXPECT_EQ(settled[0].state, ShaderState::Broken);
    EXPECT_EQ(runDoubled(), 11u) << "it waits for the other";
    for (const ShaderStatus& status : reloader.status())
        EXPECT_EQ(status.state, status.name == "gpu_test/count.comp" ? ShaderState::Broken
                                                                     : ShaderState::Waiting);

    write("count.comp", replaced(count, "kStep", "2u"));
    settled = wait(reloader);
    EXPECT_EQ(settled.size(), 2u);
    for (const ShaderStatus& status : reloader.status()) {
        EXPECT_EQ(status.state, ShaderState::Ok) << status.name;
        EXPECT_EQ(status.error, "");
        EXPECT_EQ(status.reloads, 1u);
    }
    EXPECT_EQ(runDoubled(), 16u);
    EXPECT_EQ(runCount(), 2 * counted);
}

TEST_F(ReloadTest, WhatRunsLaterIsFollowedAndWhatHasNoFileIsBroken) {
    ShaderReloader reloader = watch();
    EXPECT_TRUE(reloader.status().empty());
    runDoubled();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    EXPECT_TRUE(reloader.update(executor()).empty());
    ASSERT_EQ(reloader.status().size(), 1u);
    std::filesystem::remove(folder_ / "doubled.comp");
    EXPECT_EQ(wait(reloader)[0].state, ShaderState::Broken);
    EXPECT_EQ(runDoubled(), 11u);
}

TEST_F(ReloadTest, FramesGoOnWhileAShaderIsCompiled) {
    runDoubled();
    ShaderReloader reloader = watch();
    std::string text = original("doubled.comp");
    for (int i = 0; i < 20000; ++i)  // long enough to be seen at work
        text += fmt::format("float f{}(float x) {{ return sin(x) * {}.0; }}\n", i, i);
    write("doubled.comp", text);
    uint32_t frames = 0;
    double longest = 0.0;
    std::vector<ShaderStatus> settled;
    while (settled.empty() && frames < 100000) {
        const auto begin = Clock::now();
        settled = reloader.update(executor());
        const std::chrono::duration<double> taken = Clock::now() - begin;
        if (settled.empty()) longest = std::max(longest, taken.count());
        frames += reloader.status()[0].state == ShaderState::Compiling ? 1 : 0;
        EXPECT_EQ(runDoubled(), 11u);
    }
    EXPECT_EQ(settled[0].state, ShaderState::Ok) << settled[0].error;
    EXPECT_GT(frames, 1u);
    EXPECT_LT(longest * 1e3, settled[0].milliseconds / 4.0);  // nobody waited for the compiler
    std::cout << frames << " frames while it compiled; the longest look took " << longest * 1e3
              << " ms\n";
}

TEST_F(ReloadTest, AFolderThatIsNotThereIsNamed) {
    const auto none = ShaderReloader::create(folder_ / "none");
    EXPECT_NE(test::errorOf(none).find("none: there is no such folder"), std::string::npos);
}

}  // namespace
}  // namespace lampyris
