#include "evaluation/flicker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lampyris::evaluation {
namespace {

core::DisplayImage grey(uint32_t width, uint32_t height, uint8_t value) {
    return {width, height, std::vector<uint8_t>(size_t{width} * height * 3, value)};
}

TEST(StaticFlicker, IsZeroWhereNothingChanges) {
    StillSequence sequence;
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(sequence.add(grey(9, 7, 100)).ok());
    const auto flicker = sequence.flicker();
    ASSERT_TRUE(flicker.ok());
    EXPECT_EQ(flicker->mean, 0.0);
    EXPECT_EQ(flicker->percentile99, 0.0);
    EXPECT_EQ(flicker->average.values, grey(9, 7, 100).values);
}

TEST(StaticFlicker, OfTurnsBetweenTwoValuesIsHalfTheirDistance) {
    StillSequence sequence;
    for (int i = 0; i < 10; ++i) ASSERT_TRUE(sequence.add(grey(4, 4, i % 2 == 0 ? 90 : 110)).ok());
    const auto flicker = sequence.flicker();
    ASSERT_TRUE(flicker.ok());
    EXPECT_NEAR(flicker->mean, 10.0, 1e-9);
    EXPECT_NEAR(flicker->percentile99, 10.0, 1e-9);
    EXPECT_EQ(flicker->average.values, grey(4, 4, 100).values);
}

TEST(StaticFlicker, WeighsChannelsByLuma) {
    StillSequence sequence;
    core::DisplayImage one = grey(1, 1, 0), other = grey(1, 1, 0);
    other.values = {100, 0, 0};
    ASSERT_TRUE(sequence.add(one).ok());
    ASSERT_TRUE(sequence.add(other).ok());
    EXPECT_NEAR(sequence.flicker()->mean, 0.2126 * 50.0, 1e-9);
}

TEST(StaticFlicker, OfNoiseIsItsDeviationAndPercentileTheWorstPixels) {
    StillSequence sequence;
    std::mt19937 random(7);
    std::normal_distribution<double> calm(100.0, 3.0), wild(100.0, 20.0);
    for (int i = 0; i < 400; ++i) {
        core::DisplayImage picture = grey(50, 40, 0);
        for (size_t p = 0; p < 2000; ++p) {
            const double value = p % 50 == 0 ? wild(random) : calm(random);
            for (size_t c = 0; c < 3; ++c)
                picture.values[3 * p + c] = static_cast<uint8_t>(std::lround(value));
        }
        ASSERT_TRUE(sequence.add(picture).ok());
    }
    const auto flicker = sequence.flicker();
    ASSERT_TRUE(flicker.ok());
    const double rounding = std::sqrt(9.0 + 1.0 / 12.0);
    EXPECT_NEAR(flicker->mean, 0.98 * rounding + 0.02 * 20.0, 0.05);
    EXPECT_NEAR(flicker->percentile99, 20.0, 1.5);
}

TEST(StaticFlicker, RefusesOtherSizesAndOnePicture) {
    StillSequence sequence;
    ASSERT_TRUE(sequence.add(grey(4, 4, 1)).ok());
    EXPECT_FALSE(sequence.flicker().ok());
    EXPECT_FALSE(sequence.add(grey(5, 4, 1)).ok());
}

/// A bright bar that moves to the right, over noise of whole steps.
std::vector<core::DisplayImage> movingBar(uint32_t frames, uint8_t brightness) {
    std::vector<core::DisplayImage> pictures;
    for (uint32_t t = 0; t < frames; ++t) {
        pictures.push_back(grey(32, 16, 10));
        for (uint32_t y = 0; y < 16; ++y)
            for (uint32_t c = 0; c < 3; ++c)
                pictures.back().values[3 * (32 * y + t) + c] = brightness;
    }
    return pictures;
}

TEST(DynamicFlicker, IsZeroWhereChangesAreTheReferences) {
    const auto bar = movingBar(8, 200);
    EXPECT_EQ(dynamicFlicker(bar, bar)->mean, 0.0);
    // A picture that is brighter throughout, but changes alike.
    auto brighter = bar;
    for (auto& picture : brighter)
        for (auto& value : picture.values) value = static_cast<uint8_t>(value + 20);
    EXPECT_NEAR(dynamicFlicker(brighter, bar)->mean, 0.0, 1e-9);
}

TEST(DynamicFlicker, OfAFrameThatFlashesIsItsRiseAndItsFall) {
    const std::vector<core::DisplayImage> still(5, grey(20, 9, 50));
    auto flashes = still;
    flashes[2] = grey(20, 9, 58);
    const auto flicker = dynamicFlicker(flashes, still);
    ASSERT_TRUE(flicker.ok());
    const std::vector<double> expected{0.0, 8.0, 8.0, 0.0};
    ASSERT_EQ(flicker->frames.size(), expected.size());
    for (size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(flicker->frames[i], expected[i], 1e-9);
    EXPECT_NEAR(flicker->mean, 4.0, 1e-9);
}

TEST(DynamicFlicker, MissesWhatStaysWithinABlock) {
    // A bar that moves by a pixel within a block is no change of the block's mean.
    const auto bar = movingBar(8, 200);
    const std::vector<core::DisplayImage> still(8, bar[0]);
    EXPECT_NEAR(dynamicFlicker(bar, still)->mean, 0.0, 1e-9);
}

TEST(DynamicFlicker, RefusesSequencesThatDoNotMatch) {
    const std::vector<core::DisplayImage> three(3, grey(8, 8, 1)), two(2, grey(8, 8, 1));
    EXPECT_FALSE(dynamicFlicker(three, two).ok());
    EXPECT_FALSE(dynamicFlicker(std::span(three).first(1), std::span(two).first(1)).ok());
    const std::vector<core::DisplayImage> others(3, grey(9, 8, 1));
    EXPECT_FALSE(dynamicFlicker(three, others).ok());
}

std::vector<core::DisplayImage> decay(double start, double perFrame) {
    std::vector<core::DisplayImage> pictures;
    for (int t = 0; t <= 96; ++t)
        pictures.push_back(
            grey(3, 3, static_cast<uint8_t>(std::lround(20.0 + start * std::pow(perFrame, t)))));
    return pictures;
}

TEST(LagOfAChange, OfAnExponentialIsTheTimeToATenth) {
    // 200 · 0.8^t falls to a tenth at ln 0.1 / ln 0.8 = 10.3.
    const auto lag = lagOf(decay(200.0, 0.8));
    ASSERT_TRUE(lag.ok());
    EXPECT_TRUE(lag->arrives);
    EXPECT_EQ(lag->frames, 11u);
    EXPECT_NEAR(lag->differences[0], 200.0, 0.5);
}

TEST(LagOfAChange, OfAStepIsOneFrame) {
    std::vector<core::DisplayImage> pictures(97, grey(3, 3, 20));
    pictures[0] = grey(3, 3, 200);
    EXPECT_EQ(lagOf(pictures)->frames, 1u);
}

TEST(LagOfAChange, ThatDoesNotArriveSaysSo) {
    auto pictures = decay(200.0, 0.8);
    for (size_t t = 1; t < pictures.size(); ++t) pictures[t] = grey(3, 3, t % 2 == 0 ? 60 : 120);
    pictures[0] = grey(3, 3, 100);
    EXPECT_FALSE(lagOf(pictures)->arrives);
    EXPECT_FALSE(lagOf(std::span(pictures).first(96)).ok());
}

}  // namespace
}  // namespace lampyris::evaluation
