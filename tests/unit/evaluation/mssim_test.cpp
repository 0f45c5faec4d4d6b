#include "evaluation/mssim.h"

#include <gtest/gtest.h>

#include "unit/evaluation/known_pairs.h"

namespace lampyris::evaluation {
namespace {

TEST(Mssim, OfConstantsComparesTheirMeansAlone) {
    // Without variance SSIM is (2ab + C1) / (a² + b² + C1).
    const double c1 = 2.55 * 2.55;
    const Measure measure = mssim(grey(100), grey(120)).value();
    EXPECT_NEAR(measure.value, (2 * 100.0 * 120.0 + c1) / (100.0 * 100.0 + 120.0 * 120.0 + c1),
                1e-9);
    EXPECT_NEAR(mssim(grey(0), grey(255))->value, c1 / (255.0 * 255.0 + c1), 1e-9);
}

TEST(Mssim, LooksAtLumaOfDisplayValues) {
    const double luma = 0.2126 * 200.0 + 0.7152 * 40.0 + 0.0722 * 90.0;
    const double c1 = 2.55 * 2.55;
    EXPECT_NEAR(mssim(constant(200, 40, 90), grey(0))->value, c1 / (luma * luma + c1), 1e-9);
}

TEST(Mssim, TakesWindowsThatLieInside) {
    const Measure measure = mssim(draw(dot), grey(128)).value();
    EXPECT_EQ(measure.map.width, kWidth - 10);
    EXPECT_EQ(measure.map.height, kHeight - 10);
    // The dot at (30, 20) is in the windows around (25, 15) to (35, 25), and in no other.
    EXPECT_LT(measure.map.at(25 - 5, 15 - 5, 0), 1.0f);
    EXPECT_LT(measure.map.at(35 - 5, 25 - 5, 0), 1.0f);
    EXPECT_NEAR(measure.map.at(24 - 5, 20 - 5, 0), 1.0f, 1e-6f);
    EXPECT_NEAR(measure.map.at(30 - 5, 26 - 5, 0), 1.0f, 1e-6f);
    EXPECT_NEAR(measure.value, 0.97929310, 1e-6);  // scikit-image, known_pairs.py
}

TEST(Mssim, OfOneWindowIsAllowedAndLessIsNot) {
    EXPECT_NEAR(mssim(draw(ramp, 11, 11), draw(ramp, 11, 11))->value, 1.0, 1e-12);
    for (const auto& [width, height] : {std::pair{10u, 48u}, std::pair{64u, 10u}}) {
        const auto refused = mssim(draw(ramp, width, height), draw(ramp, width, height));
        ASSERT_FALSE(refused.ok());
        EXPECT_NE(refused.error().message.find("MSSIM needs 11x11 pixels"), std::string::npos)
            << refused.error().message;
    }
}

}  // namespace
}  // namespace lampyris::evaluation
