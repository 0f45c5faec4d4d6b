#include "thesis/path_search.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lampyris::sandbox::thesis {
namespace {

constexpr size_t kLeastProbes = 5;  // [chosen] below, one outlier tilts the line
constexpr size_t kMostProbes = 9;   // [chosen]
constexpr double kSettled = 0.02;   // [chosen] share by which the next count may still differ
constexpr double kMostPaths = 4e6;
constexpr double kFarthest = 4.0;  // from what has been measured, as a factor

struct Probe {
    double paths, cost;
};

/// Near counts tell more, since costs bend; and noise grows with the cost.
double weightOf(const Probe& probe, double near) {
    const double distance = std::log2(probe.paths / near);
    return 1.0 / ((1.0 + distance * distance) * probe.cost * probe.cost);
}

/// Where the weighted straight line through all probes meets the budget.
double meetBudget(const std::vector<Probe>& probes, double budget, double near) {
    double sum = 0.0, paths = 0.0, cost = 0.0;
    for (const Probe& p : probes) {
        const double weight = weightOf(p, near);
        sum += weight;
        paths += weight * p.paths;
        cost += weight * p.cost;
    }
    paths /= sum;
    cost /= sum;
    double square = 0.0, product = 0.0;
    for (const Probe& p : probes) {
        const double weight = weightOf(p, near);
        square += weight * (p.paths - paths) * (p.paths - paths);
        product += weight * (p.paths - paths) * (p.cost - cost);
    }
    // Noise can hide that cost grows: then only the direction is known.
    if (product <= 0.0) return cost < budget ? near * 2.0 : near / 2.0;
    return paths + (budget - cost) * square / product;
}

}  // namespace

core::Result<uint32_t> searchPaths(const CostOfPaths& cost, double budget, uint32_t guess) {
    std::vector<Probe> probes;
    double low = kMostPaths, high = 1.0;
    const auto probe = [&](double paths) -> core::Result<void> {
        paths = std::clamp(std::round(paths), 1.0, kMostPaths);
        TRY(const double measured, cost(static_cast<uint32_t>(paths)));
        probes.push_back({paths, measured});
        low = std::min(low, paths);
        high = std::max(high, paths);
        return {};
    };
    double next = std::clamp(static_cast<double>(guess), 2.0, kMostPaths / 2.0);
    for (const double first : {next / 2.0, next, next * 2.0}) TRY_VOID(probe(first));
    while (true) {
        const double last = next;
        next = meetBudget(probes, budget, last);
        next = std::clamp(next, std::max(low / kFarthest, 1.0),
                          std::min(high * kFarthest, kMostPaths));
        const bool settled = std::abs(next - last) <= kSettled * last;
        if ((settled && probes.size() >= kLeastProbes) || probes.size() >= kMostProbes) break;
        TRY_VOID(probe(next));
    }
    return static_cast<uint32_t>(std::lround(next));
}

}  // namespace lampyris::sandbox::thesis
