#include "frame_series.h"

#include <gtest/gtest.h>

#include <array>

namespace lampyris::sandbox {
namespace {

execute::FrameStatistics frameOf(std::vector<execute::NodeTime> nodes, double milliseconds) {
    execute::FrameStatistics frame;
    frame.nodes = std::move(nodes);
    frame.gpuMilliseconds = milliseconds;
    return frame;
}

TEST(FrameSeries, AddsUpThePartsOfANode) {
    FrameSeries series;
    series.add(frameOf(
        {{"gbuffer", 1.0, 0.1}, {"tile_bin/count", 2.0, 0.2}, {"tile_bin/pairs", 3.0, 0.3}}, 6.0));
    const auto nodes = series.summariseNodes();
    ASSERT_EQ(nodes.size(), 2u);
    EXPECT_EQ(nodes[0].name, "gbuffer");
    EXPECT_EQ(nodes[1].name, "tile_bin");
    EXPECT_DOUBLE_EQ(nodes[1].gpuMilliseconds.mean, 5.0);
    EXPECT_DOUBLE_EQ(nodes[1].cpuRecordMilliseconds.mean, 0.5);
}

TEST(FrameSeries, AFrameWithoutANodeCountsAsZero) {
    FrameSeries series;
    series.add(frameOf({{"gbuffer", 1.0, 0.0}}, 1.0));
    series.add(frameOf({{"upload_lights", 4.0, 0.0}, {"gbuffer", 1.0, 0.0}}, 5.0));
    series.add(frameOf({{"gbuffer", 1.0, 0.0}}, 1.0));
    EXPECT_EQ(series.gpuMilliseconds("upload_lights"), (std::vector<double>{0.0, 4.0, 0.0}));
    EXPECT_TRUE(series.gpuMilliseconds("nothing").empty());
    EXPECT_EQ(series.frames(), 3u);
}

TEST(FrameSeries, TheDifferenceToTheFrameStandsAsOther) {
    FrameSeries near;
    near.add(frameOf({{"gbuffer", 95.0, 0.0}}, 100.0));
    EXPECT_EQ(near.summariseNodes().size(), 1u);
    FrameSeries far;
    far.add(frameOf({{"gbuffer", 85.0, 0.0}}, 100.0));
    const auto nodes = far.summariseNodes();
    ASSERT_EQ(nodes.size(), 2u);
    EXPECT_EQ(nodes[1].name, "other");
    EXPECT_DOUBLE_EQ(nodes[1].gpuMilliseconds.mean, 15.0);
}

TEST(FrameSeries, SumsNodesByNameAndByBeginning) {
    FrameSeries series;
    series.add(frameOf({{"gather/a", 1.0, 0.0},
                        {"gather_more", 2.0, 0.0},
                        {"upsample", 4.0, 0.0},
                        {"up", 8.0, 0.0}},
                       15.0));
    EXPECT_EQ(series.sumOf(std::array<std::string, 2>{"gather*", "up"}), std::vector<double>{11.0});
}

}  // namespace
}  // namespace lampyris::sandbox
