// Which heat a frame has, and how many of its photons are drawn.
#include "overlay/marks.h"

#include <gtest/gtest.h>

namespace lampyris::overlay {
namespace {

using photon_gi::Gather;
using photon_gi::Pipeline;

TEST(MarkChoice, HeatIsOfWhatTheGatherMakes) {
    photon_gi::Settings settings;
    EXPECT_TRUE(hasHeat(Heat::History, settings));
    EXPECT_FALSE(hasHeat(Heat::Tiles, settings));
    settings.gather = Gather::Tiles;
    EXPECT_FALSE(hasHeat(Heat::History, settings));
    EXPECT_TRUE(hasHeat(Heat::Tiles, settings));
    settings.pipeline = Pipeline::Thesis;
    EXPECT_FALSE(hasHeat(Heat::History, settings));
    EXPECT_TRUE(hasHeat(Heat::Tiles, settings));
    settings.pipeline = Pipeline::Direct;
    EXPECT_FALSE(hasHeat(Heat::History, settings));
    EXPECT_FALSE(hasHeat(Heat::Tiles, settings));
    EXPECT_TRUE(hasHeat(Heat::None, settings));
    settings = {};
    settings.maxBounces = 0;
    EXPECT_FALSE(hasHeat(Heat::History, settings));
}

TEST(MarkChoice, DrawsAllOrEachSoManieth) {
    EXPECT_EQ(markStride(0, 0, 100), 1u);
    EXPECT_EQ(markStride(100, 50, 100), 1u);
    EXPECT_EQ(markStride(101, 50, 100), 2u);
    EXPECT_EQ(markStride(50, 301, 100), 4u);
}

}  // namespace
}  // namespace lampyris::overlay
