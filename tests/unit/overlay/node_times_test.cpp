#include "overlay/node_times.h"

#include <gtest/gtest.h>

namespace lampyris::overlay {
namespace {

execute::FrameStatistics frameOf(std::vector<execute::NodeTime> nodes, double gpu) {
    execute::FrameStatistics frame;
    frame.nodes = std::move(nodes);
    frame.gpuMilliseconds = gpu;
    return frame;
}

TEST(NodeTimes, AddUpANodesPartsUnlessTheyAreAskedForApart) {
    NodeTimes times;
    times.add(frameOf(
        {{"tile_bin/count", 1.0, 0.1}, {"gather", 4.0, 0.2}, {"tile_bin/pairs", 2.0, 0.3}}, 7.5));
    ASSERT_EQ(times.rows().size(), 2u);
    EXPECT_EQ(times.rows()[0].name, "tile_bin");
    EXPECT_FLOAT_EQ(times.rows()[0].gpu.back(), 3.0f);
    EXPECT_FLOAT_EQ(times.rows()[0].cpuRecord.back(), 0.4f);
    EXPECT_FLOAT_EQ(times.whole().gpu.back(), 7.5f);
    times.setPartsApart(true);
    ASSERT_EQ(times.rows().size(), 3u);
    EXPECT_EQ(times.rows()[2].name, "tile_bin/pairs");
    EXPECT_FLOAT_EQ(times.rows()[2].gpu.back(), 2.0f);
}

TEST(NodeTimes, GiveMedianAndP95OfTheFramesKept) {
    NodeTimes times;
    for (int i = 0; i < 400; ++i) times.add(frameOf({{"a", static_cast<double>(i), 0.0}}, i));
    // The last 240 are 160 to 399; medians may be seven frames old.
    EXPECT_EQ(times.frames().size(), NodeTimes::kFrames);
    EXPECT_EQ(times.rows()[0].gpu.size(), NodeTimes::kFrames);
    EXPECT_FLOAT_EQ(times.rows()[0].gpu.front(), 160.0f);
    EXPECT_NEAR(times.rows()[0].gpuMedian, 279.5f, 8.0f);
    EXPECT_NEAR(times.rows()[0].gpuP95, 160.0f + 0.95f * 239.0f, 8.0f);
}

TEST(NodeTimes, CountANodeThatDidNotRunAsNothing) {
    NodeTimes times;
    times.add(frameOf({{"a", 1.0, 0.0}, {"b", 2.0, 0.0}}, 3.0));
    times.add(frameOf({{"b", 2.0, 0.0}}, 2.0));
    ASSERT_EQ(times.rows().size(), 2u);
    EXPECT_EQ(times.rows()[0].name, "b") << "the last frame's order";
    EXPECT_EQ(times.rows()[1].name, "a");
    EXPECT_EQ(times.rows()[1].gpu, (std::vector<float>{1.0f, 0.0f}));
    times.add(frameOf({{"b", 3.0, 0.0}}, 3.0));
    EXPECT_EQ(times.rows()[1].gpu, (std::vector<float>{1.0f, 0.0f, 0.0f}));
    EXPECT_EQ(times.rows()[0].gpu, (std::vector<float>{2.0f, 2.0f, 3.0f}));
}

TEST(NodeTimes, DropTheRowsOfNodesThatNoFrameHasAnyMore) {
    NodeTimes times;
    times.add(frameOf({{"a", 1.0, 0.5}, {"b", 2.0, 0.5}}, 3.0));
    for (size_t i = 0; i < NodeTimes::kFrames - 1; ++i) times.add(frameOf({{"b", 2.0, 0.5}}, 2.0));
    EXPECT_EQ(times.rows().size(), 2u);
    times.add(frameOf({{"b", 2.0, 0.5}}, 2.0));
    ASSERT_EQ(times.rows().size(), 1u);
    EXPECT_EQ(times.rows()[0].name, "b");
    times.add(frameOf({{"c", 1.0, 0.5}, {"b", 2.0, 0.5}}, 3.0));
    ASSERT_EQ(times.rows().size(), 2u);
    EXPECT_EQ(times.rows()[0].gpu.size(), NodeTimes::kFrames);
    EXPECT_EQ(times.rows()[0].gpu.back(), 1.0f);
    EXPECT_EQ(times.rows()[1].gpu.back(), 2.0f);
}

TEST(NodeTimes, BeginAnewWhenTheyAreCleared) {
    NodeTimes times(true);
    times.add(frameOf({{"a/b", 1.0, 0.0}}, 3.0));
    times.clear();
    EXPECT_TRUE(times.frames().empty());
    EXPECT_TRUE(times.rows().empty());
    EXPECT_TRUE(times.partsApart());
    times.add(frameOf({{"a/b", 2.0, 0.0}}, 2.0));
    EXPECT_EQ(times.rows().at(0).gpu, std::vector<float>{2.0f});
    EXPECT_FLOAT_EQ(times.whole().gpuMedian, 2.0f);
}

TEST(NodeTimes, AreCopiedAsCsv) {
    NodeTimes times;
    times.add(frameOf({{"a", 1.5, 0.25}}, 1.75));
    EXPECT_EQ(times.csv(),
              "node,gpu_ms_median,gpu_ms_p95,cpu_record_ms_median\n"
              "a,1.5000,1.5000,0.2500\nframe,1.7500,1.7500,0.2500\n");
}

}  // namespace
}  // namespace lampyris::overlay
