#include "evaluation/flicker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "unit/evaluation/known_pairs.h"

namespace lampyris::evaluation {
namespace {

template <typename Formula>
StaticFlicker measure(int frames, const Formula& formula, FlickerMeter&& meter = {}) {
    for (int t = 0; t < frames; ++t) EXPECT_TRUE(meter.add(formula(t)).ok());
    return meter.result();
}

TEST(Flicker, OfAConstantIsNone) {
    const StaticFlicker f = measure(7, [](int) { return draw(ramp).display; });
    EXPECT_EQ(f.mean, 0.0);
    EXPECT_EQ(f.percentile99, 0.0);
    EXPECT_EQ(f.average.values, draw(ramp).display.values);
}

TEST(Flicker, OfOneFrameIsNone) {
    EXPECT_EQ(measure(1, [](int) { return draw(ramp).display; }).mean, 0.0);
}

TEST(Flicker, OfAnAlternationIsItsAmplitude) {
    const StaticFlicker f =
        measure(10, [](int t) { return grey(t % 2 == 0 ? 100 - 6 : 100 + 6).display; });
    EXPECT_NEAR(f.mean, 6.0, 1e-9);
    EXPECT_NEAR(f.percentile99, 6.0, 1e-6);
    EXPECT_EQ(f.average.values, grey(100).display.values);
}

TEST(Flicker, WeighsChannelsAsLuma) {
    const StaticFlicker f =
        measure(4, [](int t) { return constant(10, t % 2 == 0 ? 40 : 60, 30).display; });
    EXPECT_NEAR(f.mean, 0.7152 * 10.0, 1e-9);
}

TEST(Flicker, OfNoiseIsItsDeviation) {
    std::mt19937 random(7);
    std::normal_distribution<double> noise(128.0, 9.0);
    const StaticFlicker f = measure(400, [&](int) {
        core::DisplayImage image{kWidth, kHeight, {}};
        for (uint32_t p = 0; p < kWidth * kHeight; ++p)
            image.values.insert(image.values.end(), 3,
                                static_cast<uint8_t>(std::lround(noise(random))));
        return image;
    });
    // Rounding to whole values adds a variance of 1/12; an estimate from n frames is short by
    // 1 − 3/4n.
    const double expected = std::sqrt(81.0 + 1.0 / 12.0) * (1.0 - 0.75 / 400.0);
    EXPECT_NEAR(f.mean, expected, 0.03);
    // A deviation from n frames spreads by σ/√(2n); 2.326 of those lie below the 99th percentile.
    EXPECT_NEAR(f.percentile99, expected + 2.326 * 9.0 / std::sqrt(800.0), 0.1);
}

TEST(Flicker, HasThePlaceInTheMap) {
    const StaticFlicker f =
        measure(6, [](int t) { return (t % 2 == 0 ? draw(dot) : grey(128)).display; });
    EXPECT_NEAR(f.map.at(30, 20, 0), 127.0 / 2.0, 1e-4);
    EXPECT_EQ(f.map.at(31, 20, 0), 0.0f);
    EXPECT_NEAR(f.mean, 127.0 / 2.0 / (kWidth * kHeight), 1e-9);
    EXPECT_EQ(f.percentile99, 0.0) << "one pixel is less than a hundredth";
}

TEST(Flicker, TellsTheChangeOfEveryFrame) {
    FlickerMeter meter;
    for (const int value : {10, 14, 14, 7}) ASSERT_TRUE(meter.add(grey(value).display).ok());
    ASSERT_EQ(meter.changes().size(), 4u);
    for (const auto& [t, change] : {std::pair{0, 0.0}, {1, 4.0}, {2, 0.0}, {3, 7.0}})
        EXPECT_NEAR(meter.changes()[static_cast<size_t>(t)], change, 1e-9);
}

TEST(Flicker, RefusesAnotherSize) {
    FlickerMeter meter;
    EXPECT_FALSE(meter.add({}).ok());
    ASSERT_TRUE(meter.add(draw(ramp).display).ok());
    const auto refused = meter.add(draw(ramp, 8, 9).display);
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().message.find("frame 1 is 8x9"), std::string::npos);
}

}  // namespace
}  // namespace lampyris::evaluation
