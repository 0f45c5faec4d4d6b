#include "evaluation/heat_map.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "evaluation/plane.h"

namespace lampyris::evaluation {
namespace {

TEST(HeatMap, GrowsBrighterFromBlack) {
    core::Image values(256, 1, 1);
    for (uint32_t x = 0; x < 256; ++x) values.at(x, 0, 0) = static_cast<float>(x);
    const core::DisplayImage picture = heatMap(values, 255.0f);
    const Plane luma = lumaOf(picture);
    EXPECT_EQ(luma.values[0], 0.0);
    EXPECT_GT(luma.values[255], 240.0);
    for (size_t x = 1; x < 256; ++x) EXPECT_GE(luma.values[x], luma.values[x - 1]) << x;
}

TEST(HeatMap, EndsAtBothEnds) {
    core::Image values(3, 1, 1);
    values.values = {-1.0f, 2.0f, std::numeric_limits<float>::infinity()};
    const auto& v = heatMap(values, 1.0f).values;
    EXPECT_EQ((std::array{v[0], v[1], v[2]}), (std::array<uint8_t, 3>{0, 0, 0}));
    EXPECT_EQ((std::array{v[3], v[4], v[5]}), (std::array{v[6], v[7], v[8]}));
}

TEST(HeatMap, PicturesStandInTheMiddleAndSideBySide) {
    const core::DisplayImage dot{1, 1, {1, 2, 3}};
    const core::DisplayImage framed = centred(dot, 3, 3);
    const core::DisplayImage row = sideBySide(std::array{framed, centred(dot, 1, 3)});
    EXPECT_EQ(row.width, 4u);
    EXPECT_EQ(row.height, 3u);
    for (size_t i = 0; i < row.values.size(); ++i) {
        const size_t pixel = i / 3;
        const bool lit = pixel == 4 + 1 || pixel == 4 + 3;
        EXPECT_EQ(row.values[i], lit ? i % 3 + 1 : 0) << i;
    }
}

}  // namespace
}  // namespace lampyris::evaluation
