// Raster pipelines are made anew with either stage's new words, whatever else they were made with.
#include <array>

#include "core/file.h"
#include "gpu/execute/execute_test.h"
#include "shader_reload/compile_shader.h"
#include "unit/core/scratch_folder.h"

namespace lampyris {
namespace {

namespace shaders = gpu_test::shaders;

struct TrianglePush {
    std::array<float, 4> colour;
    std::array<float, 4> shift;
};

class RasterReloadTest : public test::ExecuteTest {
 protected:
    void SetUp() override {
        ExecuteTest::SetUp();
        if (IsSkipped()) return;
        vertices_ = makeBuffer<float>({-1, -1, 0.5f, 1, -1, 0.5f, -1, 1, 0.5f}, "vertices");
        tints_ = makeBuffer<float>({1, 0.5f, 0.25f, 1}, "tints");
        pipeline_.vertex = &shaders::triangleVert;
        pipeline_.fragment = &shaders::triangleFrag;
        pipeline_.attributes = {{0, 0, 3, 12}};
    }
    void TearDown() override {
        vertices_ = {};
        tints_ = {};
        ExecuteTest::TearDown();
    }
    /// A pixel of a picture that the triangle covers.
    std::array<float, 3> draw() {
        constexpr graph::Extent kSize{8, 8};
        graph::Frame frame;
        auto node = frame.raster("triangle", kSize);
        const auto vertices = import(frame, vertices_);
        const auto colour = node.clearedColour(
            0, frame.image("colour", {graph::Format::RGBA16Float, kSize}), {0, 0, 0, 1});
        (void)node.clearedColourUint(1, frame.image("id", {graph::Format::R32Uint, kSize}), 99);
        (void)node.clearedDepth(frame.image("depth", {graph::Format::D32Float, kSize}));
        node.vertices(vertices).read(0, import(frame, tints_));
        node.record({&shaders::triangleVert, &shaders::triangleFrag},
                    [=, this](graph::RasterCommands& commands) {
                        graph::Draw one;
                        one.pipeline = &pipeline_;
                        one.streams = {vertices};
                        one.count = 3;
                        one.pushConstants(TrianglePush{{1, 1, 1, 1}, {0, 0, 0, 0}});
                        commands.draw(one);
                    });
        frame.output(colour);
        const auto result = run(frame, {.readBackImages = {colour}});
        const core::Image image = execute::toImage(result.images[0]);
        return {image.at(1, 1, 0), image.at(1, 1, 1), image.at(1, 1, 2)};
    }
    /// The shader's file with `what` written otherwise.
    void replace(const graph::Shader& shader, const std::string& what, const std::string& by) {
        const std::string file{shader.source};
        const auto bytes = test::need(
            core::readFile(std::filesystem::path(LAMPYRIS_SOURCE_DIR "/tests/gpu/shaders") / file));
        std::string text(bytes.begin(), bytes.end());
        text.replace(text.find(what), what.size(), by);
        test::need(core::writeFile(folder_ / file, text));
        const auto words = test::need(shader_reload::compileShader({folder_ / "", file}));
        test::need(executor().replaceShader(shader, words));
    }

    core::ScratchFolder folder_;
    gpu::Buffer vertices_, tints_;
    graph::RasterPipeline pipeline_;
};

TEST_F(RasterReloadTest, EitherStageIsReplaced) {
    EXPECT_EQ(draw(), (std::array{1.0f, 0.5f, 0.25f}));
    replace(shaders::triangleFrag, "colour * tints.values[0]", "0.5 * colour * tints.values[0]");
    EXPECT_EQ(draw(), (std::array{0.5f, 0.25f, 0.125f}));
    replace(shaders::triangleVert, "colour = push.colour", "colour = 4.0 * push.colour");
    EXPECT_EQ(draw(), (std::array{2.0f, 1.0f, 0.5f}));
}

TEST_F(RasterReloadTest, APipelineOfAReplacedShaderMayBeAskedForLater) {
    EXPECT_EQ(draw(), (std::array{1.0f, 0.5f, 0.25f}));
    replace(shaders::triangleFrag, "colour * tints.values[0]", "0.5 * colour * tints.values[0]");
    pipeline_.depthWrite = false;
    EXPECT_EQ(draw(), (std::array{0.5f, 0.25f, 0.125f}));
}

TEST_F(RasterReloadTest, WhatIsNoShaderChangesNothing) {
    EXPECT_EQ(draw(), (std::array{1.0f, 0.5f, 0.25f}));
    const auto result = executor().replaceShader(shaders::triangleFrag, {});
    EXPECT_FALSE(result.ok());
    EXPECT_EQ(draw(), (std::array{1.0f, 0.5f, 0.25f}));
}

}  // namespace
}  // namespace lampyris
