#include "evaluation/picture.h"

#include <gtest/gtest.h>

#include <limits>

namespace lampyris::evaluation {
namespace {

TEST(Picture, OfRadianceShowsItAndKeepsIt) {
    for (const uint32_t channels : {1u, 3u, 4u}) {
        core::Image image(2, 1, channels);
        for (uint32_t c = 0; c < channels; ++c) image.at(1, 0, c) = 3.0f;
        const Picture picture = fromLinear("a", image, {-2.0f, core::Tonemap::Clip}).value();
        EXPECT_EQ(picture.linear.channels, 3u);
        EXPECT_EQ(picture.linear.at(1, 0, 2), 3.0f) << "exposure is for display values alone";
        EXPECT_EQ(picture.linear.at(0, 0, 2), 0.0f);
        EXPECT_EQ(picture.display.values, core::toDisplay(image, {-2.0f}).values);
    }
}

TEST(Picture, OfDisplayValuesStandsForTheirLight) {
    const Picture picture = fromDisplay("a", {1, 1, {0, 128, 255}});
    EXPECT_EQ(picture.linear.at(0, 0, 0), 0.0f);
    EXPECT_FLOAT_EQ(picture.linear.at(0, 0, 1), core::decodeSrgb(128.0f / 255.0f));
    EXPECT_EQ(picture.linear.at(0, 0, 2), 1.0f);
}

TEST(Picture, WithNaNOrInfinityIsNamedWithThePixel) {
    core::Image image(5, 4, 3);
    image.at(3, 2, 1) = std::numeric_limits<float>::quiet_NaN();
    const auto nan = fromLinear("a.exr", image, {});
    ASSERT_FALSE(nan.ok());
    EXPECT_EQ(nan.error().message, "a.exr: NaN in green of the pixel at (3, 2)");
    image.at(3, 2, 1) = 0.0f;
    image.at(4, 3, 2) = -std::numeric_limits<float>::infinity();
    const auto infinite = fromLinear("b.exr", image, {});
    ASSERT_FALSE(infinite.ok());
    EXPECT_EQ(infinite.error().message, "b.exr: infinity in blue of the pixel at (4, 3)");
}

TEST(Picture, IsComparedWithOneOfItsSize) {
    const auto sized = [](const char* name, uint32_t width, uint32_t height) {
        return fromDisplay(name, {width, height, std::vector<uint8_t>(width * height * 3)});
    };
    EXPECT_TRUE(checkComparable(sized("a", 4, 3), sized("b", 4, 3)).ok());
    const auto differ = checkComparable(sized("a", 4, 3), sized("b", 3, 4));
    ASSERT_FALSE(differ.ok());
    EXPECT_NE(differ.error().message.find("a is 4x3 and b is 3x4"), std::string::npos);
    EXPECT_FALSE(checkComparable(sized("a", 0, 0), sized("b", 0, 0)).ok());
}

}  // namespace
}  // namespace lampyris::evaluation
