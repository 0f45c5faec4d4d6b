#include "statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lampyris::sandbox {
namespace {

TEST(Statistics, OfAKnownSeries) {
    const Statistics s = summarise(std::vector<double>{4.0, 1.0, 3.0, 2.0, 10.0});
    EXPECT_DOUBLE_EQ(s.mean, 4.0);
    EXPECT_DOUBLE_EQ(s.stddev, std::sqrt(10.0));
    EXPECT_DOUBLE_EQ(s.median, 3.0);
    EXPECT_DOUBLE_EQ(s.p95, 4.0 + 0.8 * 6.0);
    EXPECT_DOUBLE_EQ(s.min, 1.0);
    EXPECT_DOUBLE_EQ(s.max, 10.0);
}

TEST(Statistics, MedianOfAnEvenSeriesLiesBetween) {
    EXPECT_DOUBLE_EQ(summarise(std::vector<double>{1.0, 2.0, 8.0, 9.0}).median, 5.0);
}

TEST(Statistics, OfOneAndOfNone) {
    const Statistics one = summarise(std::vector<double>{7.0});
    EXPECT_EQ(one.mean, 7.0);
    EXPECT_EQ(one.stddev, 0.0);
    EXPECT_EQ(one.p95, 7.0);
    EXPECT_EQ(summarise({}).max, 0.0);
}

}  // namespace
}  // namespace lampyris::sandbox
