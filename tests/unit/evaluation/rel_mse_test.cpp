#include "evaluation/rel_mse.h"

#include <gtest/gtest.h>

#include "unit/evaluation/known_pairs.h"

namespace lampyris::evaluation {
namespace {

Picture radiance(float value) {
    core::Image image(4, 3, 3);
    for (float& v : image.values) v = value;
    return fromLinear("radiance", image, {}).value();
}

TEST(RelMse, OfConstantsIsAFormula) {
    const Measure measure = relMse(radiance(2.5f), radiance(2.0f)).value();
    EXPECT_NEAR(measure.value, 0.25 / 4.01, 1e-9);
    EXPECT_NEAR(measure.map.at(3, 2, 0), 0.25 / 4.01, 1e-7);
}

TEST(RelMse, SeesWhatIsTooBrightForTheScreen) {
    EXPECT_NEAR(relMse(radiance(20.0f), radiance(10.0f))->value, 100.0 / 100.01, 1e-9);
    EXPECT_NEAR(relMse(radiance(0.5f), radiance(0.0f))->value, 0.25 / 0.01, 1e-6);
}

TEST(RelMse, OfDisplayValuesComparesTheirLight) {
    const double a = core::decodeSrgb(100.0f / 255.0f);
    const double b = core::decodeSrgb(200.0f / 255.0f);
    EXPECT_NEAR(relMse(grey(100), grey(200))->value, (a - b) * (a - b) / (b * b + 0.01), 1e-7);
}

}  // namespace
}  // namespace lampyris::evaluation
