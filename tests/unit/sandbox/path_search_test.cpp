#include "thesis/path_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lampyris::sandbox::thesis {
namespace {

/// A machine whose frames of `paths` cost the budget, 1.
struct Machine {
    double paths;
    double bend = 1.0;
    double noise = 0.0;  ///< share, to and fro
    int probes = 0;

    uint32_t search(uint32_t guess) {
        const auto found = searchPaths(
            [this](uint32_t n) -> core::Result<double> {
                ++probes;
                const double share = std::pow(static_cast<double>(n) / paths, bend);
                return (0.3 + 0.7 * share) * (1.0 + noise * std::sin(7.0 * probes));
            },
            1.0, guess);
        return found.value();
    }
};

TEST(PathSearch, FindsWhatCostsTheBudget) {
    for (const double paths : {12.0, 1000.0, 70000.0})
        for (const double factor : {0.1, 1.0, 12.0}) {
            Machine machine{paths};
            EXPECT_NEAR(machine.search(static_cast<uint32_t>(paths * factor) + 1), paths,
                        0.02 * paths + 1.0);
            EXPECT_LE(machine.probes, 9);
        }
}

TEST(PathSearch, CostsMayBend) {
    for (const double bend : {0.7, 1.5}) {
        Machine machine{1000.0, bend};
        EXPECT_NEAR(machine.search(400), 1000.0, 50.0);
    }
}

TEST(PathSearch, NoiseIsAveragedOut) {
    Machine machine{1000.0, 1.0, 0.05};
    EXPECT_NEAR(machine.search(300), 1000.0, 100.0);
}

TEST(PathSearch, IsOneWhereNothingIsCheapEnough) {
    const auto found =
        searchPaths([](uint32_t n) { return core::Result<double>(2.0 + n); }, 1.0, 500);
    EXPECT_EQ(found.value(), 1u);
}

TEST(PathSearch, EndsWhereCostsDoNotGrow) {
    int probes = 0;
    const auto found = searchPaths(
        [&](uint32_t) {
            ++probes;
            return core::Result<double>(0.5);
        },
        1.0, 500);
    EXPECT_GT(found.value(), 500u);
    EXPECT_LE(probes, 9);
}

TEST(PathSearch, PassesAnErrorOn) {
    const auto found = searchPaths(
        [](uint32_t) -> core::Result<double> { return core::error("no device"); }, 1.0, 500);
    ASSERT_FALSE(found.ok());
    EXPECT_EQ(found.error().message, "no device");
}

}  // namespace
}  // namespace lampyris::sandbox::thesis
