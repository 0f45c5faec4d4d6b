// Every measure against values that known_pairs.py computed: scikit-image 0.19.3 for MSSIM, numpy
// and scipy for the others.
#include "unit/evaluation/known_pairs.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "evaluation/measures.h"

namespace lampyris::evaluation {
namespace {

void expectMeasures(const Picture& image, const Picture& reference,
                    const std::array<double, 5>& expected) {
    for (size_t m = 0; m < expected.size(); ++m) {
        const NamedMeasure& named = allMeasures()[m];
        const auto measured = named.measure(image, reference);
        ASSERT_TRUE(measured.ok()) << measured.error().message;
        EXPECT_NEAR(measured->value, expected[m], 2e-6 * std::max(1.0, expected[m])) << named.name;
        if (std::string(named.name) != "NRMSE") {
            EXPECT_NEAR(meanOf(measured->map), measured->value,
                        1e-5 * std::max(1.0, measured->value))
                << named.name;
        }
    }
}

TEST(KnownPairs, NoiseOnRamps) {
    expectMeasures(draw(noisyRamp), draw(ramp),
                   {134.15603299, 0.04542186, 0.68582035, 0.06429085, 0.02077926});
}

TEST(KnownPairs, ShiftedEdges) {
    expectMeasures(draw(shiftedCheckers), draw(checkers),
                   {7237.5, 0.44775525, 0.18906289, 0.51998934, 4.38380981});
}

TEST(KnownPairs, DimmedColours) {
    expectMeasures(draw(dimCheckers), draw(checkers),
                   {1138.66666667, 0.17760071, 0.92247068, 0.54798537, 0.11463751});
}

TEST(KnownPairs, AnImageAndItself) {
    const Picture picture = draw(noisyRamp);
    expectMeasures(picture, picture, {0.0, 0.0, 1.0, 0.0, 0.0});
}

TEST(KnownPairs, StandInTheOrderOfTheProgramsLines) {
    std::string names;
    for (const NamedMeasure& measure : allMeasures()) names += std::string(measure.name) + " ";
    EXPECT_EQ(names, "MSE NRMSE MSSIM FLIP relMSE ");
}

TEST(KnownPairs, OfDifferentSizesAreRefusedByEveryMeasure) {
    const Picture small = draw(ramp, 32, 48);
    for (const NamedMeasure& measure : allMeasures()) {
        const auto refused = measure.measure(small, draw(ramp));
        ASSERT_FALSE(refused.ok()) << measure.name;
        EXPECT_NE(refused.error().message.find("is 32x48 and drawn is 64x48"), std::string::npos)
            << refused.error().message;
    }
}

}  // namespace
}  // namespace lampyris::evaluation
