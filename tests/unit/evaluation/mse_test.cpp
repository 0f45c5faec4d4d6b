#include "evaluation/mse.h"

#include <gtest/gtest.h>

#include "unit/evaluation/known_pairs.h"

namespace lampyris::evaluation {
namespace {

TEST(Mse, OfConstantsIsTheMeanOfTheSquares) {
    const Measure measure = mse(constant(10, 20, 30), constant(13, 20, 34)).value();
    EXPECT_DOUBLE_EQ(measure.value, (9.0 + 0.0 + 16.0) / 3.0);
    EXPECT_FLOAT_EQ(measure.map.at(5, 7, 0), 25.0f / 3.0f);
}

TEST(Mse, OfOnePixelIsItsShare) {
    const Measure measure = mse(draw(dot), grey(128)).value();
    EXPECT_DOUBLE_EQ(measure.value, 127.0 * 127.0 / (kWidth * kHeight));
    EXPECT_FLOAT_EQ(measure.map.at(30, 20, 0), 127.0f * 127.0f);
    EXPECT_EQ(measure.map.at(31, 20, 0), 0.0f);
    EXPECT_EQ(measure.map.width, kWidth);
    EXPECT_EQ(measure.map.channels, 1u);
}

TEST(Mse, OfBlackAndWhiteIsTheMost) {
    EXPECT_DOUBLE_EQ(mse(grey(0), grey(255))->value, 255.0 * 255.0);
}

}  // namespace
}  // namespace lampyris::evaluation
