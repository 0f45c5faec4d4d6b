#include <array>

#include "gpu/execute/execute_test.h"

namespace lampyris {
namespace {

namespace shaders = gpu_test::shaders;

struct TrianglePush {
    std::array<float, 4> colour;
    std::array<float, 4> shift;
};

class RasterTest : public test::ExecuteTest {
 protected:
    static constexpr graph::Extent kSize{32, 32};

    void SetUp() override {
        ExecuteTest::SetUp();
        if (IsSkipped()) return;
        // The half of the picture above the diagonal from the lower left to the upper right.
        vertices_ = makeBuffer<float>({-1, -1, 0.5f, 1, -1, 0.5f, -1, 1, 0.5f}, "vertices");
        indices_ = makeBuffer<uint32_t>({0, 1, 2}, "indices");
        tints_ = makeBuffer<float>({1, 0.5f, 0.25f, 1}, "tints");
        pipeline_.vertex = &shaders::triangleVert;
        pipeline_.fragment = &shaders::triangleFrag;
        pipeline_.attributes = {{0, 0, 3, 12}};
    }
    void TearDown() override {
        vertices_ = {};
        indices_ = {};
        tints_ = {};
        ExecuteTest::TearDown();
    }

    struct Targets {
        graph::Image colour, id, depth;
    };
    struct Shift {
        float red;
        float depth;
    };
    Targets draw(graph::Frame& frame, const std::vector<Shift>& draws) {
        Targets targets;
        auto node = frame.raster("triangles", kSize);
        const auto vertices = import(frame, vertices_);
        const auto indices = import(frame, indices_);
        targets.colour = node.clearedColour(
            0, frame.image("colour", {graph::Format::RGBA16Float, kSize}), {0, 0, 0, 1});
        targets.id =
            node.clearedColourUint(1, frame.image("id", {graph::Format::R32Uint, kSize}), 99);
        targets.depth = node.clearedDepth(frame.image("depth", {graph::Format::D32Float, kSize}));
        node.vertices(vertices).indices(indices).read(0, import(frame, tints_));
        node.record(
            {&shaders::triangleVert, &shaders::triangleFrag},
            [=, this](graph::RasterCommands& commands) {
                for (const Shift& shift : draws) {
                    graph::Draw one;
                    one.pipeline = &pipeline_;
                    one.streams = {vertices};
                    one.indices = indices;
                    one.count = 3;
                    one.pushConstants(TrianglePush{{shift.red, 1, 1, 1}, {0, 0, shift.depth, 0}});
                    commands.draw(one);
                }
            });
        return targets;
    }

    gpu::Buffer vertices_, indices_, tints_;
    graph::RasterPipeline pipeline_;
};

TEST_F(RasterTest, DrawsIntoEveryAttachment) {
    graph::Frame frame;
    const Targets targets = draw(frame, {{0.75f, 0.0f}});
    frame.output(targets.colour);
    const auto result = run(frame, {.readBackImages = {targets.colour, targets.id, targets.depth}});
    const core::Image colour = execute::toImage(result.images[0]);
    const core::Image depth = execute::toImage(result.images[2]);
    const auto ids = test::valuesOf<uint32_t>(result.images[1].bytes);
    EXPECT_EQ(colour.at(2, 2, 0), 0.75f);
    EXPECT_EQ(colour.at(2, 2, 1), 0.5f);
    EXPECT_EQ(colour.at(2, 2, 2), 0.25f);
    EXPECT_EQ(depth.at(2, 2, 0), 0.5f);
    EXPECT_EQ(ids[2 * 32 + 2], 7u);
    EXPECT_EQ(colour.at(30, 30, 0), 0.0f);
    EXPECT_EQ(depth.at(30, 30, 0), 0.0f);
    EXPECT_EQ(ids[30 * 32 + 30], 99u);
}

TEST_F(RasterTest, TheGreaterDepthIsNearer) {
    for (const auto& draws : {std::vector<Shift>{{0.25f, 0.0f}, {0.5f, 0.25f}},
                              std::vector<Shift>{{0.5f, 0.25f}, {0.25f, 0.0f}}}) {
        graph::Frame frame;
        const Targets targets = draw(frame, draws);
        frame.output(targets.colour);
        const auto result = run(frame, {.readBackImages = {targets.colour}});
        EXPECT_EQ(execute::toImage(result.images[0]).at(2, 2, 0), 0.5f);
    }
}

TEST_F(RasterTest, LaterNodesDrawOnWhatIsThere) {
    graph::Frame frame;
    Targets targets = draw(frame, {{0.75f, 0.0f}});
    auto node = frame.raster("again", kSize);
    const auto vertices = import(frame, vertices_);
    targets.colour = node.colour(0, targets.colour);
    targets.id = node.colour(1, targets.id);
    node.testDepth(targets.depth).vertices(vertices).read(0, import(frame, tints_));
    auto behind = pipeline_;
    behind.depthWrite = false;
    node.record({&shaders::triangleVert, &shaders::triangleFrag},
                [=](graph::RasterCommands& commands) {
                    graph::Draw one;
                    one.pipeline = &behind;
                    one.streams = {vertices};
                    one.count = 3;
                    one.pushConstants(TrianglePush{{0.1f, 1, 1, 1}, {0, 0, -0.25f, 0}});
                    commands.draw(one);
                });
    frame.output(targets.colour);
    const auto result = run(frame, {.readBackImages = {targets.colour}});
    EXPECT_EQ(execute::toImage(result.images[0]).at(2, 2, 0), 0.75f);
}

TEST_F(RasterTest, MayDrawOnlyWhatLiesOnTheSurface) {
    graph::Frame frame;
    Targets targets = draw(frame, {{0.75f, 0.0f}});
    auto node = frame.raster("on it", kSize);
    const auto vertices = import(frame, vertices_);
    targets.colour = node.colour(0, targets.colour);
    targets.id = node.colour(1, targets.id);
    node.testDepth(targets.depth).vertices(vertices).read(0, import(frame, tints_));
    auto equal = pipeline_;
    equal.depthWrite = false;
    equal.depthEqual = true;
    node.record({&shaders::triangleVert, &shaders::triangleFrag}, [=](graph::RasterCommands&
                                                                          commands) {
        for (const Shift& shift : {Shift{0.1f, -0.25f}, Shift{0.2f, 0.0f}, Shift{0.3f, 0.25f}}) {
            graph::Draw one;
            one.pipeline = &equal;
            one.streams = {vertices};
            one.count = 3;
            one.pushConstants(TrianglePush{{shift.red, 1, 1, 1}, {0, 0, shift.depth, 0}});
            commands.draw(one);
        }
    });
    frame.output(targets.colour);
    const auto result = run(frame, {.readBackImages = {targets.colour}});
    EXPECT_NEAR(execute::toImage(result.images[0]).at(2, 2, 0), 0.2f, 1e-3f);
}

TEST_F(RasterTest, BuffersThatWereNotDeclaredAreRefused) {
    graph::Frame frame;
    auto node = frame.raster("sly", kSize);
    const auto hidden = import(frame, vertices_);
    const auto colour =
        node.clearedColour(0, frame.image("colour", {graph::Format::RGBA16Float, kSize}));
    node.read(0, import(frame, tints_));
    node.record({&shaders::triangleVert, &shaders::triangleFrag},
                [=, this](graph::RasterCommands& commands) {
                    graph::Draw one;
                    one.pipeline = &pipeline_;
                    one.streams = {hidden};
                    one.count = 3;
                    one.pushConstants(TrianglePush{});
                    commands.draw(one);
                });
    frame.output(colour);
    const std::string message = test::errorOf(executor().run(frame));
    EXPECT_NE(message.find("sly"), std::string::npos) << message;
    EXPECT_NE(message.find("VertexRead"), std::string::npos) << message;
}

}  // namespace
}  // namespace lampyris
