#include "evaluation/dynamic_flicker.h"

#include <gtest/gtest.h>

#include "unit/evaluation/known_pairs.h"

namespace lampyris::evaluation {
namespace {

using Sequence = std::vector<core::DisplayImage>;

template <typename Formula>
Sequence sequence(int frames, const Formula& frameAt) {
    Sequence images;
    for (int t = 0; t < frames; ++t) images.push_back(frameAt(t).display);
    return images;
}

/// An edge that moves three pixels a frame; `brighter` is added everywhere.
Picture movingEdge(int t, int brighter = 0) {
    return draw([=](int x, int, int) { return (x < 5 + 3 * t ? 200 : 40) + brighter; });
}

TEST(DynamicFlicker, OfTheSameMotionIsNone) {
    const Sequence moving = sequence(6, [](int t) { return movingEdge(t); });
    const auto flicker = dynamicFlicker(moving, moving);
    ASSERT_TRUE(flicker.ok());
    EXPECT_EQ(flicker->value, 0.0);
    EXPECT_EQ(flicker->changes.size(), 5u);
}

TEST(DynamicFlicker, DoesNotCountASteadyError) {
    const auto flicker = dynamicFlicker(sequence(6, [](int t) { return movingEdge(t, 11); }),
                                        sequence(6, [](int t) { return movingEdge(t); }));
    EXPECT_NEAR(flicker->value, 0.0, 1e-9);
}

TEST(DynamicFlicker, CountsWhatTremblesOverTheMotion) {
    // ±4 at every other frame is a change of 8.
    const auto flicker =
        dynamicFlicker(sequence(6, [](int t) { return movingEdge(t, t % 2 == 0 ? -4 : 4); }),
                       sequence(6, [](int t) { return movingEdge(t); }));
    EXPECT_NEAR(flicker->value, 8.0, 1e-9);
    for (const double change : flicker->changes) EXPECT_NEAR(change, 8.0, 1e-9);
}

TEST(DynamicFlicker, CountsMotionThatIsMissed) {
    // Three columns of 160 a frame, in a picture 64 wide.
    const auto flicker = dynamicFlicker(sequence(6, [](int) { return movingEdge(0); }),
                                        sequence(6, [](int t) { return movingEdge(t); }));
    EXPECT_NEAR(flicker->value, 160.0 * 3.0 / 64.0, 1e-9);
}

TEST(DynamicFlicker, LooksAtMeansOfBlocks) {
    // Neighbours that tremble against each other cancel within a block.
    const auto checkered = [](int t) {
        return draw([=](int x, int y, int) { return 100 + ((x + y + t) % 2 == 0 ? 20 : -20); });
    };
    const Sequence still = sequence(4, [](int) { return grey(100); });
    EXPECT_NEAR(dynamicFlicker(sequence(4, checkered), still)->value, 0.0, 1e-9);
}

TEST(DynamicFlicker, TakesBlocksAtTheBorderForWhatTheyAre) {
    const auto blink = [](int t) {
        return draw([=](int, int, int) { return t % 2 == 0 ? 10 : 30; }, 20, 12);
    };
    const Sequence still = sequence(3, [&](int) { return blink(0); });
    EXPECT_NEAR(dynamicFlicker(sequence(3, blink), still)->value, 20.0, 1e-9);
}

TEST(DynamicFlicker, IsVoidWhereTheFloorIsAQuarter) {
    DynamicFlicker flicker;
    flicker.value = 4.0;
    EXPECT_TRUE(flicker.valid(0.99));
    EXPECT_FALSE(flicker.valid(1.0));
    flicker.value = 0.0;
    EXPECT_FALSE(flicker.valid(0.0));
}

TEST(DynamicFlicker, RefusesSequencesThatDoNotFit) {
    const Sequence two = sequence(2, [](int) { return grey(1); });
    EXPECT_FALSE(dynamicFlicker(std::span{two}.first(1), std::span{two}.first(1)).ok());
    EXPECT_FALSE(dynamicFlicker(two, std::span{two}.first(1)).ok());
    const Sequence other = sequence(2, [](int) { return draw(ramp, 8, 9); });
    EXPECT_FALSE(dynamicFlicker(two, other).ok());
}

}  // namespace
}  // namespace lampyris::evaluation
