#include "photon_gi/cost_curve.h"

#include <cmath>

namespace lampyris::photon_gi {
namespace {

// [chosen] How far a budget may go: an eighth of the paths, if that many are left, in cells half as
// wide again, one ray a texel of 16 pixels squared.
constexpr double kLeastPathShare = 1.0 / 8.0;
constexpr double kLeastPaths = 256.0;
constexpr double kWidestCells = 1.5;
constexpr uint32_t kCoarsest = 16;
// [chosen] A step leaves about two thirds of the rays.
constexpr double kRaysLeft = 0.67;
constexpr double kDivisorStep = 1.25;
// [chosen] A step is taken where it saves this much of the cost, and taken back where that is met
// with so much to spare.
constexpr double kLeastSaved = 0.05;
constexpr double kSpare = 1.05;
constexpr int kHalvings = 30;

}  // namespace

IndirectCost modelCost(const Settings& s, graph::Extent size) {
    // [measured] courtyard, 640x360, 16000 paths, 0.5 m, 6 rays, divisor 4: the table in BUDGET.md.
    const double pixels = static_cast<double>(size.width) * size.height / (640.0 * 360.0);
    const double paths = s.photonPaths / 16000.0;
    const double radius = static_cast<double>(s.radiusMetres) / 0.5;
    const double rays = s.gatherRays / 6.0;
    const double divisor = s.gatherDivisor / 4.0;
    return {138.0 * paths + 430.0 * std::pow(paths, 0.54) * std::pow(radius, -0.4),
            272.0 * pixels * std::pow(rays, 0.8) * std::pow(divisor, -1.9),
            267.0 * std::pow(pixels, 0.55) * std::pow(rays, 0.82) * std::pow(divisor, 0.87)};
}

CostCurve::CostCurve(const Settings& asked, graph::Extent size) : asked_(asked), size_(size) {
    Step step{asked.gatherDivisor, asked.gatherRays};
    steps_.push_back(step);
    while (step.gatherRays > 1) {
        const long left = std::lround(kRaysLeft * step.gatherRays);
        step.gatherRays = std::max(1u, static_cast<uint32_t>(left));
        steps_.push_back(step);
    }
    while (step.gatherDivisor < kCoarsest) {
        const double coarser = std::ceil(kDivisorStep * step.gatherDivisor);
        step.gatherDivisor = std::min(kCoarsest, static_cast<uint32_t>(coarser));
        steps_.push_back(step);
    }
}

Settings CostCurve::settingsAt(const Place& place) const {
    const Step& step = steps_[place.level];
    const double most = asked_.photonPaths;
    const double least = std::min(most, std::max(kLeastPathShare * most, kLeastPaths));
    const double given = 1.0 - place.share;
    Settings s = asked_;
    s.gatherDivisor = step.gatherDivisor;
    s.gatherRays = step.gatherRays;
    s.photonPaths = static_cast<uint32_t>(std::lround(most * std::pow(least / most, given)));
    s.radiusMetres *= static_cast<float>(std::pow(kWidestCells, given));
    return s;
}

double CostCurve::costAt(const Place& place) const {
    return modelCost(settingsAt(place), size_).times(factors_).sum();
}

double CostCurve::shareFor(size_t level, double cost) const {
    double low = 0.0;
    double high = 1.0;
    if (cost <= costAt({level, low})) return low;
    if (cost >= costAt({level, high})) return high;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (low + high);
        (costAt({level, middle}) < cost ? low : high) = middle;
    }
    return high;
}

bool CostCurve::pays(size_t level) const {
    return level + 1 < steps_.size() &&
           costAt({level + 1, 1.0}) < (1.0 - kLeastSaved) * costAt({level, 1.0});
}

Place CostCurve::find(double cost, const Place& from) const {
    size_t level = std::min(from.level, steps_.size() - 1);
    while (pays(level) && cost < costAt({level, kStepShare})) ++level;
    if (level <= from.level)
        while (level > 0 && cost > costAt({level, 1.0}) && cost > costOfStepBack(level)) --level;
    return {level, shareFor(level, cost)};
}

double CostCurve::costOfStepBack(size_t level) const {
    return kSpare * costAt({level - 1, kStepShare});
}

Place CostCurve::least() const {
    size_t level = 0;
    while (pays(level)) ++level;
    return {level, 0.0};
}

bool CostCurve::isLeast(const Place& place) const {
    return place.share == 0.0 && !pays(place.level);
}

double CostCurve::quality(const Place& place) const {
    if (isLeast(place)) return 0.0;
    const double most = std::log(costAt({}));
    const double fewest = std::log(costAt(least()));
    if (most <= fewest) return 1.0;
    return std::clamp((std::log(costAt(place)) - fewest) / (most - fewest), 0.0, 1.0);
}

}  // namespace lampyris::photon_gi
