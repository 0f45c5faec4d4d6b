#include "thesis/path_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace lampyris::sandbox::thesis {
namespace {

constexpr double kTolerance = 0.02;  // [chosen] about the standard deviation of a quiet frame time
constexpr int kMostProbes = 12;      // [chosen]
constexpr uint32_t kMostPaths = 1u << 22;

struct Probe {
    uint32_t paths;
    double cost;
};

/// What the search knows: a count that costs too little, and one that costs too much.
struct Bracket {
    std::optional<Probe> below, above;

    void add(const Probe& probe, double budget) {
        (probe.cost < budget ? below : above) = probe;
        // Noise: a smaller count cost more than a larger one. The older of the two is let go.
        if (below && above && below->paths >= above->paths)
            (probe.cost < budget ? above : below).reset();
    }
};

/// On the line between both ends, but well inside: costs bend.
uint32_t between(const Probe& below, const Probe& above, double budget) {
    const double share = std::clamp((budget - below.cost) / (above.cost - below.cost), 0.1, 0.9);
    return static_cast<uint32_t>(std::lround(
        std::lerp(static_cast<double>(below.paths), static_cast<double>(above.paths), share)));
}

/// The next count worth a probe, or none.
std::optional<uint32_t> nextPaths(const Bracket& bracket, double budget) {
    std::optional<uint32_t> next;
    if (bracket.below && bracket.above)
        next = between(*bracket.below, *bracket.above, budget);
    else if (bracket.below)
        next = std::min(bracket.below->paths * 2, kMostPaths);
    else
        next = bracket.above->paths / 2;
    const bool known = *next == 0 || (bracket.below && *next == bracket.below->paths) ||
                       (bracket.above && *next == bracket.above->paths);
    if (known) return std::nullopt;
    return next;
}

}  // namespace

core::Result<uint32_t> searchPaths(const CostOfPaths& cost, double budget, uint32_t guess) {
    Bracket bracket;
    Probe best{1, std::numeric_limits<double>::infinity()};
    std::optional<uint32_t> paths = std::clamp(guess, 1u, kMostPaths);
    for (int i = 0; i < kMostProbes && paths; ++i) {
        TRY(const double measured, cost(*paths));
        const Probe probe{*paths, measured};
        if (std::abs(probe.cost - budget) < std::abs(best.cost - budget)) best = probe;
        if (std::abs(probe.cost - budget) <= kTolerance * budget) break;
        bracket.add(probe, budget);
        paths = nextPaths(bracket, budget);
    }
    return best.paths;
}

}  // namespace lampyris::sandbox::thesis
