#include "scene/builtin/numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace lampyris::scene::builtin {
namespace {

TEST(Numbers, HashIsKnownAndSpread) {
    static_assert(hashBits(0, 0) == 0);
    EXPECT_NE(hashBits(1, 2), hashBits(2, 1));
    std::set<uint32_t> seen;
    double sum = 0.0;
    constexpr uint32_t kCount = 20000;
    for (uint32_t i = 0; i < kCount; ++i) {
        seen.insert(hashBits(5, i));
        const float u = hashUnit(5, i);
        ASSERT_GE(u, 0.0f);
        ASSERT_LT(u, 1.0f);
        sum += u;
    }
    EXPECT_EQ(seen.size(), kCount);
    // Five standard deviations of the mean of that many uniform numbers.
    EXPECT_NEAR(sum / kCount, 0.5, 5.0 * std::sqrt(1.0 / 12.0 / kCount));
}

TEST(Numbers, SinesAgreeWithTheLibraryOverSeveralTurns) {
    constexpr double kTurn = 6.283185307179586476925;
    for (int i = -3000; i <= 3000; ++i) {
        const double turns = i / 1000.0;
        const SinCos ours = sinCosTurns(turns);
        EXPECT_NEAR(ours.sin, std::sin(turns * kTurn), 5e-15) << turns;
        EXPECT_NEAR(ours.cos, std::cos(turns * kTurn), 5e-15) << turns;
    }
}

TEST(Numbers, QuarterTurnsAreExact) {
    EXPECT_EQ(sinCosTurns(0.25).sin, 1.0);
    EXPECT_EQ(sinCosTurns(0.25).cos, 0.0);
    EXPECT_EQ(sinCosTurns(-0.5).cos, -1.0);
    EXPECT_EQ(sinCosTurns(7.75).sin, -1.0);
}

}  // namespace
}  // namespace lampyris::scene::builtin
