#include "reference/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/display.h"

namespace lampyris::reference {
namespace {

using assets::Filter;
using assets::Wrap;

/// Two by two: 0, 100 above 200, 250 in red; half in green; alpha 51.
const assets::TextureImage kImage{
    "four", 2, 2, {0, 128, 0, 51, 100, 128, 0, 51, 200, 128, 0, 51, 250, 128, 0, 51}};

float red(glm::vec2 uv, Wrap wrap = Wrap::Clamp, Filter filter = Filter::Linear) {
    assets::TextureUse use;
    use.wrapU = use.wrapV = wrap;
    use.filter = filter;
    return 255.0f * lookUp(kImage, use, uv, Encoding::Linear).r;
}

TEST(Texture, TexelCentresAreExactAndBetweenThemIsMixed) {
    EXPECT_NEAR(red({0.25f, 0.25f}), 0.0f, 1e-4f);
    EXPECT_NEAR(red({0.75f, 0.25f}), 100.0f, 1e-4f);
    EXPECT_NEAR(red({0.25f, 0.75f}), 200.0f, 1e-4f);
    EXPECT_NEAR(red({0.5f, 0.25f}), 50.0f, 1e-4f);
    EXPECT_NEAR(red({0.5f, 0.5f}), 137.5f, 1e-4f);
    EXPECT_NEAR(red({0.625f, 0.25f}), 75.0f, 1e-4f);
}

TEST(Texture, WrapsAsItIsTold) {
    EXPECT_NEAR(red({0.0f, 0.25f}, Wrap::Clamp), 0.0f, 1e-4f);
    EXPECT_NEAR(red({0.0f, 0.25f}, Wrap::Repeat), 50.0f, 1e-4f);
    EXPECT_NEAR(red({0.0f, 0.25f}, Wrap::Mirror), 0.0f, 1e-4f);
    EXPECT_NEAR(red({1.25f, 0.25f}, Wrap::Repeat), 0.0f, 1e-4f);
    EXPECT_NEAR(red({1.25f, 0.25f}, Wrap::Mirror), 100.0f, 1e-4f);
    EXPECT_NEAR(red({1.25f, 0.25f}, Wrap::Clamp), 100.0f, 1e-4f);
    EXPECT_NEAR(red({-0.25f, 0.25f}, Wrap::Repeat), 100.0f, 1e-4f);
    EXPECT_NEAR(red({-0.25f, 0.25f}, Wrap::Mirror), 0.0f, 1e-4f);
}

TEST(Texture, NearestMixesNothing) {
    EXPECT_NEAR(red({0.49f, 0.49f}, Wrap::Repeat, Filter::Nearest), 0.0f, 1e-4f);
    EXPECT_NEAR(red({0.51f, 0.49f}, Wrap::Repeat, Filter::Nearest), 100.0f, 1e-4f);
    EXPECT_NEAR(red({1.01f, 0.49f}, Wrap::Repeat, Filter::Nearest), 0.0f, 1e-4f);
}

TEST(Texture, DecodesSrgbBeforeItMixesAndLeavesAlphaLinear) {
    const assets::TextureUse use;
    const glm::vec4 between = lookUp(kImage, use, {0.5f, 0.25f}, Encoding::Srgb);
    EXPECT_NEAR(between.r, 0.5f * core::decodeSrgb(100.0f / 255.0f), 1e-6f);
    EXPECT_NEAR(between.g, core::decodeSrgb(128.0f / 255.0f), 1e-6f);
    EXPECT_NEAR(between.a, 0.2f, 1e-6f);
}

TEST(Texture, AnyCoordinateAndAnEmptyImageAreSafe) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::infinity(), -3e38f, 3e38f})
        for (const Wrap wrap : {Wrap::Repeat, Wrap::Clamp, Wrap::Mirror}) {
            EXPECT_TRUE(std::isfinite(red({bad, 0.3f}, wrap)));
            EXPECT_TRUE(std::isfinite(red({0.3f, bad}, wrap, Filter::Nearest)));
        }
    EXPECT_EQ(lookUp({}, {}, {0.5f, 0.5f}, Encoding::Linear), glm::vec4(1.0f));
}

}  // namespace
}  // namespace lampyris::reference
