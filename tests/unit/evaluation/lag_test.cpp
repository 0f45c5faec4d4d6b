#include "evaluation/lag.h"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/evaluation/known_pairs.h"

namespace lampyris::evaluation {
namespace {

template <typename Formula>
std::optional<Lag> measure(const Formula& valueAt) {
    LagMeter meter;
    for (int t = 0; t <= static_cast<int>(kLagLast); ++t)
        EXPECT_TRUE(meter.add(grey(static_cast<int>(std::lround(valueAt(t)))).display).ok());
    EXPECT_TRUE(meter.complete());
    return meter.result();
}

TEST(Lag, OfAStepIsOneFrame) {
    const auto lag = measure([](int t) { return t == 0 ? 200.0 : 20.0; });
    ASSERT_TRUE(lag.has_value());
    EXPECT_EQ(lag->frames, 1u);
    EXPECT_EQ(lag->rest, 0.0);
    EXPECT_NEAR(lag->differences[0], 180.0, 1e-4);
}

TEST(Lag, OfADecayIsThatOfItsTimeConstant) {
    // e^(−t/τ) ≤ 1/10 from t = τ ln 10 on: 18.4 frames at τ 8.
    const auto lag = measure([](int t) { return 20.0 + 200.0 * std::exp(-t / 8.0); });
    ASSERT_TRUE(lag.has_value());
    EXPECT_EQ(lag->frames, 19u);
    ASSERT_EQ(lag->differences.size(), kLagLast + 1);
    EXPECT_NEAR(lag->differences[8], 200.0 * std::exp(-1.0), 0.5);
}

TEST(Lag, CountsFramesThatShowNothingYet) {
    const auto lag = measure([](int t) { return t < 3 ? 0.0 : 100.0; });
    EXPECT_EQ(lag->frames, 3u);
}

TEST(Lag, ThatFlickerHidesIsNone) {
    const auto lag = measure([](int t) { return t == 0 ? 100.0 : (t % 2 == 0 ? 130.0 : 170.0); });
    ASSERT_TRUE(lag.has_value());
    EXPECT_FALSE(lag->frames.has_value());
    EXPECT_NEAR(lag->rest, 20.0 / 49.4, 0.01);
}

TEST(Lag, OfNoChangeIsNone) {
    EXPECT_FALSE(measure([](int) { return 50.0; }).has_value());
}

TEST(Lag, LooksAtNoMoreFrames) {
    LagMeter meter;
    for (size_t t = 0; t <= kLagLast; ++t)
        ASSERT_TRUE(meter.add(grey(t == 0 ? 9 : 0).display).ok());
    ASSERT_TRUE(meter.add(grey(255).display).ok());
    EXPECT_EQ(meter.result()->differences.size(), kLagLast + 1);
}

TEST(Lag, RefusesAnotherSize) {
    LagMeter meter;
    EXPECT_FALSE(meter.add({}).ok());
    ASSERT_TRUE(meter.add(draw(ramp).display).ok());
    EXPECT_FALSE(meter.add(draw(ramp, 8, 9).display).ok());
}

}  // namespace
}  // namespace lampyris::evaluation
