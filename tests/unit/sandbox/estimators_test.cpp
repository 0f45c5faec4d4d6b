#include "thesis/estimators.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "thesis/printed.h"

namespace lampyris::sandbox::thesis {
namespace {

std::vector<Affordable> sampled(double c1, double c2) {
    std::vector<Affordable> measured;
    for (const double r : {0.25, 0.5, 0.75, 1.0, 1.5, 2.0})
        measured.push_back({r, c1 / r + c2 / (r * r)});
    return measured;
}

TEST(Estimators, FindTheConstantsThatMadeTheData) {
    const auto linear = fitEstimators(sampled(1100.0, 0.0));
    EXPECT_NEAR(linear[0].c1, 1100.0, 1e-6);
    EXPECT_NEAR(linear[0].rmsPhotons, 0.0, 1e-6);
    EXPECT_GT(linear[1].rmsPhotons, 10.0);
    EXPECT_NEAR(linear[2].c1, 1100.0, 1e-6);
    EXPECT_NEAR(linear[2].c2, 0.0, 1e-6);

    const auto quadratic = fitEstimators(sampled(0.0, 330.0));
    EXPECT_NEAR(quadratic[1].c2, 330.0, 1e-6);
    EXPECT_NEAR(quadratic[1].rmsPhotons, 0.0, 1e-6);

    const auto both = fitEstimators(sampled(600.0, 165.0));
    EXPECT_NEAR(both[2].c1, 600.0, 1e-6);
    EXPECT_NEAR(both[2].c2, 165.0, 1e-6);
    EXPECT_NEAR(both[2].at(0.5), 1860.0, 1e-6);
}

TEST(Estimators, AreLeastInSquares) {
    std::vector<Affordable> noisy = sampled(600.0, 165.0);
    for (size_t i = 0; i < noisy.size(); ++i) noisy[i].photons *= i % 2 == 0 ? 1.1 : 0.8;
    const auto rms = [&](double c1, double c2) {
        double squares = 0.0;
        for (const Affordable& a : noisy) {
            const Estimator e{"", c1, c2};
            squares += std::pow(e.at(a.radiusMetres) - a.photons, 2.0);
        }
        return std::sqrt(squares / static_cast<double>(noisy.size()));
    };
    const auto fitted = fitEstimators(noisy);
    for (const Estimator& e : fitted) EXPECT_NEAR(e.rmsPhotons, rms(e.c1, e.c2), 1e-9);
    for (const double step : {-1.0, 1.0}) {
        EXPECT_GT(rms(fitted[0].c1 + step, 0.0), fitted[0].rmsPhotons);
        EXPECT_GT(rms(0.0, fitted[1].c2 + step), fitted[1].rmsPhotons);
        EXPECT_GT(rms(fitted[2].c1 + step, fitted[2].c2), fitted[2].rmsPhotons);
        EXPECT_GT(rms(fitted[2].c1, fitted[2].c2 + step), fitted[2].rmsPhotons);
    }
}

// Computed apart, in exact fractions and by Gram–Schmidt, from table 6.2's stored photons.
TEST(Estimators, OfTheThesisOwnTable) {
    std::vector<Affordable> printed;
    for (const PrintedRow& row : table62())
        printed.push_back({row.radiusMetres, static_cast<double>(row.stored)});
    const auto fitted = fitEstimators(printed);
    EXPECT_NEAR(fitted[0].c1, 1113.139, 0.01);
    EXPECT_NEAR(fitted[1].c2, 329.828, 0.01);
    EXPECT_NEAR(fitted[2].c1, 596.333, 0.01);
    EXPECT_NEAR(fitted[2].c2, 165.120, 0.01);
    EXPECT_NEAR(fitted[2].rmsPhotons, 113.306, 0.01);
}

TEST(Estimators, NeedTwoRadii) {
    const std::vector<Affordable> one{{0.5, 10.0}, {0.5, 12.0}};
    EXPECT_DEATH(static_cast<void>(fitEstimators(one)), "determinant");
}

}  // namespace
}  // namespace lampyris::sandbox::thesis
