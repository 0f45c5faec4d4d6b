#include "reference/owen_sobol.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace lampyris::reference {
namespace {

std::vector<glm::vec4> points(uint32_t seed, uint32_t group, uint32_t count, uint32_t first = 0) {
    std::vector<glm::vec4> all;
    for (uint32_t i = first; i < first + count; ++i) all.push_back(OwenSobol(seed, i).group(group));
    return all;
}

/// Whether each of the `across` · `along` equal boxes of two dimensions holds as many points.
bool evenly(const std::vector<glm::vec4>& all, int x, int y, uint32_t across, uint32_t along) {
    std::vector<uint32_t> counts(size_t{across} * along, 0);
    for (const glm::vec4& p : all)
        ++counts[static_cast<size_t>(p[x] * static_cast<float>(across)) * along +
                 static_cast<size_t>(p[y] * static_cast<float>(along))];
    const auto wanted = static_cast<uint32_t>(all.size() / counts.size());
    return std::all_of(counts.begin(), counts.end(), [&](uint32_t n) { return n == wanted; });
}

TEST(OwenSobol, EveryDimensionIsStratifiedInEveryAlignedBlock) {
    for (const uint32_t first : {0u, 64u, 192u})
        for (const uint32_t group : {0u, 5u, 400u})
            for (int d = 0; d < 4; ++d) {
                const auto all = points(9, group, 64, first);
                EXPECT_TRUE(evenly(all, d, d == 0 ? 1 : 0, 64, 1)) << d << " from " << first;
            }
}

TEST(OwenSobol, TheFirstTwoDimensionsAreANet) {
    // Every box of area 1/256, however long and thin, holds one of 256 points.
    for (uint32_t seed = 0; seed < 20; ++seed)
        for (uint32_t across = 1; across <= 256; across *= 2)
            EXPECT_TRUE(evenly(points(seed, 3, 256), 0, 1, across, 256 / across)) << across;
}

TEST(OwenSobol, EveryPairOfDimensionsIsSpread) {
    for (int x = 0; x < 4; ++x)
        for (int y = 0; y < x; ++y)
            EXPECT_TRUE(evenly(points(4, 2, 1024), x, y, 8, 8)) << x << " and " << y;
}

TEST(OwenSobol, GroupsAndSeedsAreIndependent) {
    const auto correlation = [](const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b,
                                int x, int y) {
        double sum = 0.0;
        for (size_t i = 0; i < a.size(); ++i) sum += (a[i][x] - 0.5) * (b[i][y] - 0.5);
        return 12.0 * sum / static_cast<double>(a.size());
    };
    for (int x = 0; x < 4; ++x)
        for (int y = 0; y < 4; ++y) {
            EXPECT_LT(std::abs(correlation(points(1, 0, 4096), points(1, 1, 4096), x, y)), 0.06);
            EXPECT_LT(std::abs(correlation(points(1, 0, 4096), points(2, 0, 4096), x, y)), 0.06);
        }
}

TEST(OwenSobol, IntegratesASmoothFunctionFasterThanChance) {
    // Chance would leave an error of about 0.3 / √4096 = 0.005.
    double square = 0.0;
    for (uint32_t seed = 0; seed < 16; ++seed) {
        double sum = 0.0;
        for (const glm::vec4& p : points(seed, 1, 4096))
            sum += std::sin(math::kPi * p.x) * p.y * p.z * p.w;
        const double error = sum / 4096.0 - 2.0 / M_PI / 8.0;
        square += error * error / 16.0;
    }
    EXPECT_LT(std::sqrt(square), 2e-4);
}

TEST(OwenSobol, ScramblesAreUnbiased) {
    // One sample each of many seeds must be plain random numbers.
    std::vector<uint32_t> counts(16, 0);
    const uint32_t seeds = 16000;
    for (uint32_t seed = 0; seed < seeds; ++seed) {
        const glm::vec4 p = OwenSobol(mixSeeds(1, seed), 0).group(7);
        ++counts[static_cast<size_t>(p.y * 4.0f) * 4 + static_cast<size_t>(p.w * 4.0f)];
    }
    double chi2 = 0.0;
    for (const uint32_t n : counts) chi2 += (n - 1000.0) * (n - 1000.0) / 1000.0;
    EXPECT_LT(chi2, 44.0);  // 15 degrees of freedom, 1 in 10000
}

TEST(OwenSobol, SequencesDoNotRepeatBeforeTheirEnd) {
    std::set<float> seen;
    for (const glm::vec4& p : points(3, 0, kLongestSequence)) seen.insert(p.x);
    EXPECT_GT(seen.size(), kLongestSequence - 400u);  // 24 bits: a few fall together
}

}  // namespace
}  // namespace lampyris::reference
