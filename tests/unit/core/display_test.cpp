#include "core/display.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lampyris::core {
namespace {

uint8_t shown(float radiance, const DisplayTransform& transform = {}) {
    Image image(1, 1, 1);
    image.values[0] = radiance;
    return toDisplay(image, transform).values[0];
}

TEST(Display, EncodesAsTheStandardSays) {
    EXPECT_FLOAT_EQ(encodeSrgb(0.0f), 0.0f);
    EXPECT_NEAR(encodeSrgb(0.0031308f), 0.04045f, 1e-5f);
    EXPECT_NEAR(encodeSrgb(0.214041f), 0.5f, 1e-5f);
    EXPECT_NEAR(encodeSrgb(1.0f), 1.0f, 1e-6f);
    for (int i = 0; i <= 255; ++i) {
        const float encoded = static_cast<float>(i) / 255.0f;
        EXPECT_NEAR(encodeSrgb(decodeSrgb(encoded)), encoded, 1e-5f);
        EXPECT_EQ(shown(decodeSrgb(encoded)), i);
    }
}

TEST(Display, ClipsAtBothEnds) {
    EXPECT_EQ(shown(-3.0f), 0);
    EXPECT_EQ(shown(1.0f), 255);
    EXPECT_EQ(shown(1e30f), 255);
    EXPECT_EQ(shown(std::numeric_limits<float>::infinity()), 255);
    EXPECT_EQ(shown(std::numeric_limits<float>::quiet_NaN()), 0);
}

TEST(Display, ExposureIsAPowerOfTwo) {
    EXPECT_EQ(shown(0.25f, {1.0f, Tonemap::Clip}), shown(0.5f));
    EXPECT_EQ(shown(0.25f, {-2.0f, Tonemap::Clip}), shown(0.0625f));
}

TEST(Display, FilmicRisesAndEndsWhite) {
    const DisplayTransform filmic{0.0f, Tonemap::Filmic};
    int last = -1;
    for (const float radiance : {0.0f, 0.01f, 0.1f, 0.5f, 1.0f, 4.0f}) {
        EXPECT_GT(shown(radiance, filmic), last);
        last = shown(radiance, filmic);
    }
    EXPECT_EQ(shown(0.0f, filmic), 0);
    EXPECT_EQ(shown(1000.0f, filmic), 255);
    EXPECT_LT(shown(1.0f, filmic), 255) << "unlike clip, one is not yet white";
}

TEST(Display, TakesOneThreeOrFourChannels) {
    for (const uint32_t channels : {1u, 3u, 4u}) {
        Image image(2, 1, channels);
        for (uint32_t c = 0; c < channels; ++c) image.at(1, 0, c) = c == 3 ? 0.0f : 1.0f;
        const DisplayImage display = toDisplay(image, {});
        EXPECT_EQ(display.values, (std::vector<uint8_t>{0, 0, 0, 255, 255, 255}))
            << channels << " channels";
    }
}

TEST(DisplayDeath, RefusesTwoChannels) {
    EXPECT_DEATH(toDisplay(Image(1, 1, 2), {}), "2 != 2");
}

}  // namespace
}  // namespace lampyris::core
