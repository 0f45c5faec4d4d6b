#include <numeric>

#include "gpu/execute/execute_test.h"

namespace lampyris {
namespace {

using test::addDouble;
using test::need;

class TimingTest : public test::ExecuteTest {
 protected:
    static constexpr uint32_t kCount = 1 << 20;
    static void declare(graph::Frame& frame, const gpu::Buffer& source) {
        const auto first = addDouble(frame, "first", import(frame, source), kCount);
        frame.output(addDouble(frame, "second", first, kCount));
    }
    graph::CompiledGraph compile(const graph::Frame& frame) {
        graph::CompileOptions options;
        options.memory = &executor().memoryModel();
        return need(graph::compile(frame, options));
    }
};

TEST_F(TimingTest, EveryNodeHasItsTime) {
    const auto source = makeBuffer(std::vector<uint32_t>(kCount, 1));
    graph::Frame frame;
    declare(frame, source);
    need(executor().run(frame));  // the first dispatch compiles
    const auto statistics = need(executor().run(frame)).statistics;
    ASSERT_EQ(statistics.nodes.size(), 2u);
    EXPECT_EQ(statistics.nodes[0].name, "first");
    EXPECT_EQ(statistics.nodes[1].name, "second");
    double sum = 0.0;
    for (const auto& node : statistics.nodes) {
        EXPECT_GT(node.gpuMilliseconds, 0.0);
        EXPECT_GE(node.cpuRecordMilliseconds, 0.0);
        sum += node.gpuMilliseconds;
    }
    EXPECT_LE(sum, statistics.gpuMilliseconds * 1.0001);
    EXPECT_LE(statistics.gpuMilliseconds, statistics.wallMilliseconds);
    EXPECT_GT(statistics.deviceBytes, uint64_t{4} * kCount);
}

TEST_F(TimingTest, UntimedFramesHaveNoDeviceTimes) {
    const auto source = makeBuffer(std::vector<uint32_t>(kCount, 1));
    graph::Frame frame;
    declare(frame, source);
    const auto statistics = need(executor().run(frame, {.timed = false})).statistics;
    EXPECT_EQ(statistics.gpuMilliseconds, 0.0);
    EXPECT_GT(statistics.wallMilliseconds, 0.0);
}

TEST_F(TimingTest, FramesMayRunAhead) {
    const auto source = makeBuffer(std::vector<uint32_t>(kCount, 1));
    graph::Frame frame;
    declare(frame, source);
    const auto graph = compile(frame);
    EXPECT_FALSE(need(executor().runAhead(frame, graph)).has_value());
    for (int i = 0; i < 5; ++i) {
        const auto before = need(executor().runAhead(frame, graph));
        ASSERT_TRUE(before.has_value());
        EXPECT_EQ(before->nodes.size(), 2u);
    }
    EXPECT_TRUE(need(executor().finish()).has_value());
    EXPECT_FALSE(need(executor().finish()).has_value());
}

TEST_F(TimingTest, AFrameWithoutNodesIsFine) {
    const graph::Frame frame;
    const auto result = need(executor().run(frame));
    EXPECT_TRUE(result.statistics.nodes.empty());
}

}  // namespace
}  // namespace lampyris
