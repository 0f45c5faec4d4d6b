/// \file Whether samples follow the density they claim: Pearson's test, over cells of the sphere or
/// over anything counted.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "reference/warps.h"

namespace lampyris::reference {

constexpr double kFewestExpected = 5.0;  // a cell below this joins the others below it

/// Fails where counts differ from expectations by more than chance: 1 in 10000.
inline void expectFollows(const std::vector<double>& counted, const std::vector<double>& expected) {
    double chi2 = 0.0, pooledCount = 0.0, pooledExpected = 0.0;
    int cells = 0;
    const auto add = [&](double count, double wanted) {
        chi2 += (count - wanted) * (count - wanted) / wanted;
        ++cells;
    };
    for (size_t i = 0; i < counted.size(); ++i) {
        if (expected[i] >= kFewestExpected) {
            add(counted[i], expected[i]);
        } else {
            pooledCount += counted[i];
            pooledExpected += expected[i];
        }
    }
    if (pooledExpected >= kFewestExpected) {
        add(pooledCount, pooledExpected);
    } else {
        EXPECT_LE(pooledCount, pooledExpected + 8.0) << "where hardly any should be";
    }
    ASSERT_GT(cells, 1);
    // Wilson and Hilferty: the cube root of chi² over its degrees of freedom is nearly normal.
    const double k = cells - 1;
    const double z = (std::cbrt(chi2 / k) - (1.0 - 2.0 / (9.0 * k))) / std::sqrt(2.0 / (9.0 * k));
    EXPECT_LT(z, 3.72) << "chi² " << chi2 << " over " << k << " degrees of freedom";
}

/// Draws `count` directions with sample(xi) and compares them with density(direction) a steradian,
/// in cells about an axis that grow from it: rings at angles π·(i/n)^power. Directions for which
/// sample gives zero length count as not drawn; the density then integrates to less than 1.
template <typename Sample, typename Density>
void expectDirectionsFollow(const glm::vec3& axis, const Sample& sample, const Density& density,
                            double power = 1.0, uint32_t count = 200000) {
    constexpr int kRings = 24, kSectors = 16, kSub = 24;
    const Frame frame(axis);
    const auto ringEdge = [&](double ring) { return M_PI * std::pow(ring / kRings, power); };
    std::vector<double> counted(kRings * kSectors, 0.0), expected(kRings * kSectors, 0.0);
    std::mt19937 random(7);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    const auto number = [&] { return std::min(uniform(random), 0x1.fffffep-1f); };
    for (uint32_t i = 0; i < count; ++i) {
        const glm::vec3 local = frame.toLocal(sample(glm::vec2(number(), number())));
        if (glm::dot(local, local) < 0.5f) continue;
        ASSERT_NEAR(glm::length(local), 1.0f, 1e-4f);
        const double theta = std::atan2(std::hypot(local.x, local.y), local.z);
        const double phi = std::atan2(local.y, local.x) / (2.0 * M_PI) + 0.5;
        const int ring = static_cast<int>(std::pow(theta / M_PI, 1.0 / power) * kRings);
        const int sector = static_cast<int>(phi * kSectors);
        ++counted[static_cast<size_t>(std::min(ring, kRings - 1) * kSectors +
                                      std::min(sector, kSectors - 1))];
    }
    for (int ring = 0; ring < kRings; ++ring)
        for (int sector = 0; sector < kSectors; ++sector) {
            double sum = 0.0;
            for (int i = 0; i < kSub; ++i) {
                const double low = ringEdge(ring + i / double(kSub));
                const double high = ringEdge(ring + (i + 1) / double(kSub));
                const double theta = 0.5 * (low + high);
                const double solid =
                    (std::cos(low) - std::cos(high)) * 2.0 * M_PI / kSectors / kSub;
                for (int j = 0; j < kSub; ++j) {
                    const double phi = 2.0 * M_PI * ((sector + (j + 0.5) / kSub) / kSectors - 0.5);
                    const glm::vec3 local(glm::dvec3(std::sin(theta) * std::cos(phi),
                                                     std::sin(theta) * std::sin(phi),
                                                     std::cos(theta)));
                    sum += solid * static_cast<double>(density(frame.toWorld(local)));
                }
            }
            expected[static_cast<size_t>(ring * kSectors + sector)] = sum * count;
        }
    expectFollows(counted, expected);
}

}  // namespace lampyris::reference
