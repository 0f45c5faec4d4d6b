#include "evaluation/flip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "evaluation/flip_colour.h"
#include "unit/evaluation/known_pairs.h"

namespace lampyris::evaluation {
namespace {

// HyAB of green and blue after Hunt's adjustment, from CIE L*a*b* by hand:
// green (87.736, −75.610, 72.981), blue (32.298, 25.578, −34.836).
constexpr double kGreenToBlue = 203.30165461;

/// FLIP of two constants that are so far apart, by formula.
double flipAt(double distance) {
    const double share = std::pow(distance / kGreenToBlue, 0.7);
    return share < 0.4 ? share * 0.95 / 0.4 : 0.95 + (share - 0.4) / 0.6 * 0.05;
}

double lightness(int grey) {
    return 116.0 * std::cbrt(core::decodeSrgb(static_cast<float>(grey) / 255.0f)) - 16.0;
}

TEST(Flip, OfConstantGreysIsTheirDifferenceInLightness) {
    EXPECT_NEAR(flip(grey(100), grey(110))->value, flipAt(lightness(110) - lightness(100)), 1e-6);
    EXPECT_NEAR(flip(grey(0), grey(255))->value, flipAt(100.0), 1e-6);
}

// By formula, in known_pairs.py.
TEST(Flip, OfConstantColours) {
    EXPECT_NEAR(flip(grey(0), grey(255))->value, 0.96737976, 1e-6);
    EXPECT_NEAR(flip(constant(200, 30, 30), constant(30, 30, 200))->value, 0.95200939, 1e-6);
    EXPECT_NEAR(flip(grey(100), grey(110))->value, 0.15346057, 1e-6);
    EXPECT_NEAR(flip(constant(0, 255, 0), constant(0, 0, 255))->value, 1.0, 1e-6);
}

TEST(Flip, DoesNotCareWhichIsTheReference) {
    EXPECT_DOUBLE_EQ(flip(draw(noisyRamp), draw(ramp))->value,
                     flip(draw(ramp), draw(noisyRamp))->value);
}

TEST(Flip, SeesADotWhereItIs) {
    const Measure measure = flip(draw(dot), grey(128)).value();
    EXPECT_NEAR(measure.value, 0.00139975, 1e-7);  // known_pairs.py
    float most = 0.0f;
    for (const float value : measure.map.values) most = std::max(most, value);
    EXPECT_EQ(measure.map.at(30, 20, 0), most);
    EXPECT_GT(most, 0.1f);
    EXPECT_EQ(measure.map.at(0, 0, 0), 0.0f) << "no filter reaches so far";
}

TEST(FlipColour, ReturnsFromOpponentColours) {
    const Colour rgb{0.1, 0.6, 0.3};
    const Colour back = screenColourOf(opponentOf(rgb));
    for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(back[c], rgb[c], 1e-9);
    const Colour white = opponentOf({1.0, 1.0, 1.0});
    EXPECT_NEAR(white[0], 100.0, 1e-9);
    EXPECT_NEAR(white[1], 0.0, 1e-9);
    EXPECT_NEAR(white[2], 0.0, 1e-9);
}

TEST(FlipColour, IsClampedToTheScreen) {
    const Colour rgb = screenColourOf({200.0, 300.0, -300.0});
    for (const double channel : rgb) {
        EXPECT_GE(channel, 0.0);
        EXPECT_LE(channel, 1.0);
    }
}

TEST(FlipColour, DistanceAddsLightnessAndChroma) {
    EXPECT_DOUBLE_EQ(hyabDistance({50.0, 3.0, 4.0}, {40.0, 0.0, 0.0}), 15.0);
}

}  // namespace
}  // namespace lampyris::evaluation
