#include "evaluation/plane.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

namespace lampyris::evaluation {
namespace {

TEST(Plane, GaussianIsEvenAndSumsToOne) {
    const auto kernel = gaussian(1.5, 5);
    ASSERT_EQ(kernel.size(), 11u);
    EXPECT_NEAR(std::accumulate(kernel.begin(), kernel.end(), 0.0), 1.0, 1e-15);
    for (size_t i = 0; i < 5; ++i) EXPECT_DOUBLE_EQ(kernel[i], kernel[10 - i]);
    EXPECT_NEAR(kernel[6] / kernel[5], std::exp(-0.5 / 2.25), 1e-15);
}

TEST(Plane, IsFilteredAlongItsRowsOrColumnsWithTheBorderRepeated) {
    Plane plane(3, 2);
    plane.values = {1, 2,  4,  //
                    8, 16, 32};
    const std::array kernel{100.0, 10.0, 1.0};  // left or above, itself, right or below
    EXPECT_EQ(filterRows(plane, kernel).values,
              (std::vector<double>{112, 124, 244, 896, 992, 1952}));
    EXPECT_EQ(filterColumns(plane, kernel).values,
              (std::vector<double>{118, 236, 472, 188, 376, 752}));
}

TEST(Plane, TakesKernelsWiderThanItself) {
    Plane plane(2, 1);
    plane.values = {3, 5};
    const std::array kernel{1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
    EXPECT_EQ(filterRows(plane, kernel).values,
              (std::vector<double>{4 * 3 + 3 * 5, 3 * 3 + 4 * 5}));
    EXPECT_EQ(filterColumns(plane, kernel).values, (std::vector<double>{21, 35}));
}

TEST(Plane, LumaWeighsDisplayValues) {
    EXPECT_DOUBLE_EQ(lumaOf({1, 1, {100, 200, 50}}).values[0],
                     0.2126 * 100 + 0.7152 * 200 + 0.0722 * 50);
}

}  // namespace
}  // namespace lampyris::evaluation
