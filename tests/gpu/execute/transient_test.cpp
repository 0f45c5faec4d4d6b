#include <algorithm>

#include "gpu/execute/execute_test.h"

namespace lampyris {
namespace {

using test::addDouble;
using test::need;

class TransientTest : public test::ExecuteTest {
 protected:
    static constexpr uint32_t kCount = 4096;

    /// Eight doublings in a row: only neighbours live at the same time.
    static graph::Buffer chain(graph::Frame& frame, const gpu::Buffer& source) {
        graph::Buffer last = import(frame, source);
        for (int i = 0; i < 8; ++i)
            last = addDouble(frame, ("link " + std::to_string(i)).c_str(), last, kCount);
        frame.output(last);
        return last;
    }
    std::vector<uint32_t> runChain(const gpu::Buffer& source,
                                   const graph::CompileOptions& options) {
        graph::Frame frame;
        const auto last = chain(frame, source);
        auto result =
            need(executor().run(frame, {.timed = false, .readBackBuffers = {last}}, options));
        statistics_ = result.statistics;
        return test::valuesOf<uint32_t>(result.buffers[0]);
    }
    execute::FrameStatistics statistics_;
};

TEST_F(TransientTest, SharedMemoryChangesNoResult) {
    const auto source = makeBuffer(std::vector<uint32_t>(kCount, 3));
    const auto apart = runChain(source, {.alias = false});
    const uint64_t bytesApart = statistics_.transientBytes;
    const auto shared = runChain(source, {});
    EXPECT_LT(statistics_.transientBytes, bytesApart);
    EXPECT_EQ(statistics_.transientBytesWithoutAliasing, bytesApart);
    EXPECT_EQ(shared, apart);
    EXPECT_EQ(shared, std::vector<uint32_t>(kCount, 3 << 8));
}

TEST_F(TransientTest, PoisonAndAnyOrderChangeNoResult) {
    const auto source = makeBuffer(std::vector<uint32_t>(kCount, 3));
    for (const uint64_t seed : {1u, 2u, 3u})
        EXPECT_EQ(runChain(source, {.randomOrderSeed = seed, .poisonTransients = true}),
                  std::vector<uint32_t>(kCount, 3 << 8));
}

TEST_F(TransientTest, PoisonIsSeenByWhoDoesNotWriteFirst) {
    // The dispatch covers half of its output; the rest keeps the poison.
    const auto source = makeBuffer(std::vector<uint32_t>(kCount, 3));
    graph::Frame frame;
    auto node = frame.compute("half", gpu_test::shaders::doubled);
    node.read(0, import(frame, source)).push(test::DoublePush{kCount / 2, 0});
    const auto out = node.write(1, frame.buffer("out", {4 * kCount}));
    node.dispatch(kCount / 128);
    frame.output(out);
    const auto result = need(executor().run(frame, {.timed = false, .readBackBuffers = {out}},
                                            {.poisonTransients = true}));
    const auto got = test::valuesOf<uint32_t>(result.buffers[0]);
    EXPECT_EQ(got[0], 6u);
    EXPECT_EQ(got[kCount - 1], graph::kPoisonWord);
}

TEST_F(TransientTest, PoisonedImagesHoldNoNumber) {
    graph::Frame frame;
    const graph::Extent size{16, 16};
    auto node = frame.compute("part", gpu_test::shaders::coordinates);
    const auto image = node.write(0, frame.image("part", {graph::Format::RGBA32Float, size}));
    node.dispatch(1, 1);
    frame.output(image);
    const auto result = need(executor().run(frame, {.timed = false, .readBackImages = {image}},
                                            {.poisonTransients = true}));
    const core::Image got = execute::toImage(result.images[0]);
    EXPECT_EQ(got.at(7, 7, 0), 7.0f);
    EXPECT_TRUE(std::isnan(got.at(8, 8, 0)));
}

TEST_F(TransientTest, FramesOfAnotherShapeFollowEachOther) {
    const auto source = makeBuffer(std::vector<uint32_t>(kCount, 3));
    for (const uint32_t count : {64u, 4096u, 128u, 64u}) {
        graph::Frame frame;
        const auto out = addDouble(frame, "double", import(frame, source), count);
        frame.output(out);
        const auto got = run(frame, {.readBackBuffers = {out}});
        EXPECT_EQ(test::valuesOf<uint32_t>(got.buffers[0]), std::vector<uint32_t>(count, 6));
    }
}

TEST_F(TransientTest, AreFoundWhereAFrameImportsMore) {
    const auto source = makeBuffer(std::vector<uint32_t>(64, 3));
    const auto more = makeBuffer(std::vector<uint32_t>(64, 5));
    for (const bool both : {false, true, false}) {
        graph::Frame frame;
        if (both) import(frame, more);
        const auto first = addDouble(frame, "first", import(frame, source), 64);
        const auto out = addDouble(frame, "second", first, 64);
        frame.output(out);
        const auto got = run(frame, {.readBackBuffers = {out}});
        EXPECT_EQ(test::valuesOf<uint32_t>(got.buffers[0]), std::vector<uint32_t>(64, 12));
    }
}

TEST_F(TransientTest, OnlyWhatIsKeptCanBeReadBack) {
    const auto source = makeBuffer(std::vector<uint32_t>(64, 3));
    graph::Frame frame;
    const auto middle = addDouble(frame, "middle", import(frame, source), 64);
    frame.output(addDouble(frame, "last", middle, 64));
    const std::string message = test::errorOf(executor().run(frame, {.readBackBuffers = {middle}}));
    EXPECT_NE(message.find("middle out"), std::string::npos) << message;
}

}  // namespace
}  // namespace lampyris
