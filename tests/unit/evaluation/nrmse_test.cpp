#include "evaluation/nrmse.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "unit/evaluation/known_pairs.h"

namespace lampyris::evaluation {
namespace {

TEST(Nrmse, DividesByTheRangeOfTheReferenceOverAllChannels) {
    // The reference's least value is 40 in red, its most 240 in blue.
    const Measure measure = nrmse(constant(50, 110, 250), constant(40, 100, 240)).value();
    EXPECT_DOUBLE_EQ(measure.value, 10.0 / 200.0);
    EXPECT_FLOAT_EQ(measure.map.at(0, 0, 0), 0.05f);
}

TEST(Nrmse, TakesTheRootAsTheThesissTablesDo) {
    // Table 6.1, first row: MSE 902.23 is printed as 0.1458, and 902.23 / 0.1458² is 206².
    const auto image = [](int x, int, int) { return x == 0 ? 0 : 206; };
    const auto other = [](int x, int, int) { return x == 0 ? 30 : 206; };
    const double share = 1.0 / kWidth;  // of pixels that differ, by 30
    EXPECT_DOUBLE_EQ(nrmse(draw(other), draw(image))->value, 30.0 * std::sqrt(share) / 206.0);
}

TEST(Nrmse, OfAReferenceWithoutRangeIsInfiniteOrZero) {
    EXPECT_EQ(nrmse(grey(3), grey(4))->value, std::numeric_limits<double>::infinity());
    const Measure same = nrmse(grey(4), grey(4)).value();
    EXPECT_EQ(same.value, 0.0);
    EXPECT_EQ(same.map.at(0, 0, 0), 0.0f);
}

}  // namespace
}  // namespace lampyris::evaluation
