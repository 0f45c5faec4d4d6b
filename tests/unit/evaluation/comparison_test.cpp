// All measures together, against values that known_pairs.py computed: scikit-image 0.19.3 for
// MSSIM, numpy and scipy for the others.
#include "unit/evaluation/known_pairs.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "evaluation/comparison.h"
#include "evaluation/flip.h"
#include "evaluation/mse.h"
#include "evaluation/mssim.h"
#include "evaluation/nrmse.h"
#include "evaluation/plane.h"
#include "evaluation/rel_mse.h"

namespace lampyris::evaluation {
namespace {

void expectMeasures(const Picture& image, const Picture& reference,
                    const std::array<double, 5>& expected) {
    const auto compared = compare(image, reference);
    ASSERT_TRUE(compared.ok()) << compared.error().message;
    const auto figures = figuresOf(*compared);
    for (size_t m = 0; m < expected.size(); ++m)
        EXPECT_NEAR(figures[m].value, expected[m], 2e-6 * std::max(1.0, expected[m]))
            << figures[m].name;
    for (const Measure& m : {compared->mse, compared->mssim, compared->flip, compared->relMse})
        EXPECT_NEAR(meanOf(m.map), m.value, 1e-5 * std::max(1.0, m.value));
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

TEST(Comparison, HasItsFiguresInTheOrderOfTheProgramsLines) {
    Comparison comparison;
    comparison.relMse.value = 5.0;
    std::string names;
    for (const Figure& figure : figuresOf(comparison)) names += std::string(figure.name) + " ";
    EXPECT_EQ(names, "MSE NRMSE MSSIM FLIP relMSE ");
    EXPECT_EQ(figuresOf(comparison)[4].value, 5.0);
}

TEST(Comparison, OfDifferentSizesIsRefusedByEveryMeasure) {
    const Picture small = draw(ramp, 32, 48);
    const Picture picture = draw(ramp);
    for (const auto measure : {&mse, &nrmse, &mssim, &flip, &relMse}) {
        const auto refused = measure(small, picture);
        ASSERT_FALSE(refused.ok());
        EXPECT_NE(refused.error().message.find("is 32x48 and drawn is 64x48"), std::string::npos)
            << refused.error().message;
    }
    EXPECT_FALSE(compare(small, picture).ok());
}

TEST(Comparison, DrawsItsMapsSideBySide) {
    const core::DisplayImage maps = drawMaps(compare(draw(dot), grey(128)).value());
    ASSERT_EQ(maps.width, 3 * kWidth);
    ASSERT_EQ(maps.height, kHeight);
    const Plane luma = lumaOf(maps);
    const auto at = [&](uint32_t map, uint32_t x, uint32_t y) {
        return luma.values[y * maps.width + map * kWidth + x];
    };
    for (const uint32_t map : {0u, 1u, 2u}) {
        EXPECT_GT(at(map, 30, 20), 0.0) << map;
        EXPECT_EQ(at(map, 2, 2), 0.0) << map;
        EXPECT_EQ(at(map, 60, 40), 0.0) << map;
    }
    EXPECT_GT(at(0, 30, 20), 240.0) << "a difference of 127 is off the scale";
    EXPECT_EQ(at(0, 31, 20), 0.0);
}

}  // namespace
}  // namespace lampyris::evaluation
