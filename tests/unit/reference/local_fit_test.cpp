#include "reference/local_fit.h"

#include <gtest/gtest.h>

#include <random>

namespace lampyris::reference {
namespace {

TEST(LocalFit, FindsTheSurfaceThatIsThere) {
    LocalFit fit;
    for (int y = -1; y <= 3; ++y)
        for (int x = -2; x <= 1; ++x)
            fit.add({x, y},
                    glm::dvec3(5.0, 1.0, 0.0) + glm::dvec3(2.0, -1.0, 0.5) * double(x) +
                        glm::dvec3(0.0, 3.0, -0.5) * double(y * y) +
                        glm::dvec3(0.3, 0.0, 1.0) * double(x * y),
                    1.0);
    EXPECT_LT(glm::length(fit.atCentre().value - glm::dvec3(5.0, 1.0, 0.0)), 1e-12);
}

TEST(LocalFit, IsAMeanWhereNoMoreIsKnown) {
    LocalFit few, row;
    few.add({1, 0}, glm::dvec3(2.0), 4.0);
    few.add({0, 1}, glm::dvec3(4.0), 4.0);
    EXPECT_NEAR(few.atCentre().value.y, 3.0, 1e-12);
    EXPECT_NEAR(few.atCentre().variance, 2.0, 1e-12);
    for (int x = 0; x < 20; ++x) row.add({x, 0}, glm::dvec3(x), 1.0);
    EXPECT_NEAR(row.atCentre().value.x, 9.5, 1e-12);
}

TEST(LocalFit, ItsVarianceIsThatOverManyTrials) {
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, 2.0);
    constexpr int kTrials = 4000;
    double squares = 0.0, claimed = 0.0;
    for (int trial = 0; trial < kTrials; ++trial) {
        LocalFit fit;
        for (int y = 0; y <= 4; ++y)  // a border: all neighbours on one side
            for (int x = -4; x <= 4; ++x) fit.add({x, y}, glm::dvec3(7.0 + noise(random)), 4.0);
        const auto estimate = fit.atCentre();
        squares += (estimate.value.x - 7.0) * (estimate.value.x - 7.0) / kTrials;
        claimed += estimate.variance / kTrials;
    }
    EXPECT_NEAR(squares / claimed, 1.0, 0.08);
}

}  // namespace
}  // namespace lampyris::reference
