#include "photon_gi/budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace lampyris::photon_gi {
namespace {

// [chosen] A cost that is far off is believed after a few frames, one that is a little off after
// more: what wavers by chance moves nothing.                                                  [U2]
struct Evidence {
    size_t frames;
    double off;  ///< of what is wanted, as a share
};
constexpr std::array kEvidence{Evidence{6, 0.15}, Evidence{10, 0.1}, Evidence{16, 0.07},
                               Evidence{28, 0.05}};
// [chosen] Of the way to what is wanted, by its logarithm, in one move: devices may follow settings
// more steeply than the model does.
constexpr double kGain = 0.75;
constexpr double kMostDown = 0.6, kMostUp = 1.4;  // of the cost, in one move
// [chosen] A step back that is wider than that is taken all the same where three quarters of the
// way lead so far beyond it: devices that follow settings more steeply would hunt there.
constexpr double kStepSpare = 1.05;
// [chosen] Standard errors of the median that a cost must be off besides: a machine that others use
// as well trembles more than one that does nothing else.
constexpr double kDeviations = 2.0;
constexpr uint32_t kFramesOfChange = 2;  // kept paths are traced anew, buffers are made

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

/// Of the median of some values, as a share of it: from their median distance to it.
double standardError(const std::vector<double>& values) {
    const double median = medianOf(values);
    std::vector<double> distances;
    distances.reserve(values.size());
    for (const double value : values) distances.push_back(std::abs(value - median));
    // 1.48 for a normal distribution's spread, 1.25 for a median's beside a mean's.
    return 1.48 * 1.25 * medianOf(std::move(distances)) /
           (median * std::sqrt(static_cast<double>(values.size())));
}

/// Whether there is something that a budget steers.
bool steers(const Settings& s) {
    return finalGathers(s) && s.maxBounces > 0 && s.photonPaths > 0;
}

/// Whether the way down is the same.
bool sameWay(const Settings& a, const Settings& b) {
    return a.photonPaths == b.photonPaths && a.radiusMetres == b.radiusMetres &&
           a.gatherRays == b.gatherRays && a.gatherDivisor == b.gatherDivisor;
}

/// Whether indirect light costs the same with both.
bool sameCost(Settings before, const Settings& now) {
    before.seed = now.seed;
    before.history = now.history;
    before.lightCutoff = now.lightCutoff;
    before.shadows = now.shadows;
    before.shadowDivisor = now.shadowDivisor;
    before.shadowRays = now.shadowRays;
    return before == now;
}

}  // namespace

std::string whatWasGivenUp(const Settings& asked, const Settings& given) {
    std::string text;
    const auto add = [&](const char* what, const std::string& was, const std::string& is) {
        if (was == is) return;
        text += fmt::format("{}{} {} instead of {}", text.empty() ? "" : ", ", what, is, was);
    };
    const auto whole = [](uint32_t number) { return fmt::format("{}", number); };
    add("paths", whole(asked.photonPaths), whole(given.photonPaths));
    add("radius", fmt::format("{:.3g}", asked.radiusMetres),
        fmt::format("{:.3g}", given.radiusMetres));
    add("gather rays", whole(asked.gatherRays), whole(given.gatherRays));
    add("gather divisor", whole(asked.gatherDivisor), whole(given.gatherDivisor));
    return text;
}

IndirectCost Budget::factorsOf(size_t frames) const {
    const auto first = factors_.end() - static_cast<std::ptrdiff_t>(frames);
    const auto median = [&](double IndirectCost::*part) {
        std::vector<double> values;
        for (auto factor = first; factor != factors_.end(); ++factor)
            values.push_back((*factor).*part);
        return medianOf(std::move(values));
    };
    return {median(&IndirectCost::photons), median(&IndirectCost::gather),
            median(&IndirectCost::upsample)};
}

double Budget::errorOf(size_t frames) const {
    const IndirectCost model = modelCost(curve_->settingsAt(place_), size_);
    std::vector<double> sums;
    for (auto factor = factors_.end() - static_cast<std::ptrdiff_t>(frames);
         factor != factors_.end(); ++factor)
        sums.push_back(model.times(*factor).sum());
    return standardError(sums);
}

void Budget::follow(const Settings& asked, graph::Extent size) {
    if (curve_ && asked == asked_ && size == size_) return;
    const bool alike = curve_ && size == size_ && sameCost(asked_, asked);
    if (!curve_ || !sameWay(asked_, asked)) place_ = {};  // its steps were others
    asked_ = asked;
    size_ = size;
    curve_.emplace(asked, size);
    // Factors to the model carry over; those of a few frames are kept until there are more, so that
    // a size that changes all the time is learned from too.
    if (!alike && factors_.size() >= kEvidence.front().frames) {
        known_ = factorsOf(factors_.size());
        factors_.clear();
    }
    if (!known_) return;
    curve_->setFactors(*known_);
    if (!alike) moveTo(curve_->find(wanted_, place_));
}

bool Budget::moveTo(const Place& place) {
    if (place == place_) return false;
    const uint32_t divisor = curve_->settingsAt(place_).gatherDivisor;
    place_ = place;
    ++changes_;
    if (curve_->settingsAt(place_).gatherDivisor != divisor) ++begun_;
    return true;
}

double Budget::targetFrom(double now) const {
    const double factor = std::pow(wanted_ / now, kGain);
    const double target = std::clamp(factor, kMostDown, kMostUp) * now;
    if (place_.share < 1.0 || place_.level == 0) return target;
    // Where rays cost far more than paths, no move would ever reach the step back.
    const double back = curve_->costOfStepBack(place_.level);
    if (factor * now <= kStepSpare * back) return target;
    return std::max(target, std::nextafter(back, 2.0 * back));
}

void Budget::steer() {
    for (const auto& [frames, off] : kEvidence) {
        if (factors_.size() < frames) return;
        known_ = factorsOf(frames);
        curve_->setFactors(*known_);
        const double now = curve_->costAt(place_);
        if (std::abs(now / wanted_ - 1.0) <= std::max(off, kDeviations * errorOf(frames))) continue;
        if (!moveTo(curve_->find(targetFrom(now), place_))) return;
        factors_.clear();
        toSkip_ = kFramesOfChange;
        return;
    }
}

Settings Budget::next(const Settings& asked, graph::Extent size) {
    if (!steers(asked)) {
        curve_.reset();
        asked_ = asked;
        return asked;
    }
    follow(asked, size);
    steer();
    return curve_->settingsAt(place_);
}

void Budget::learn(const IndirectCost& cost) {
    if (!curve_ || !(cost.sum() > 0.0) || !std::isfinite(cost.sum())) return;
    if (toSkip_ > 0) {
        --toSkip_;
        return;
    }
    const IndirectCost model = modelCost(curve_->settingsAt(place_), size_);
    factors_.push_back(
        {cost.photons / model.photons, cost.gather / model.gather, cost.upsample / model.upsample});
    if (factors_.size() > kEvidence.back().frames) factors_.pop_front();
}

BudgetState Budget::state() const {
    BudgetState state;
    state.wantedMilliseconds = wanted_;
    state.asked = state.given = asked_;
    state.changes = changes_;
    state.begun = begun_;
    if (!curve_) return state;
    state.given = curve_->settingsAt(place_);
    state.quality = curve_->quality(place_);
    if (!factors_.empty())
        state.milliseconds = modelCost(state.given, size_).times(factorsOf(factors_.size())).sum();
    state.outOfReach =
        curve_->isLeast(place_) && state.milliseconds > (1.0 + kEvidence.front().off) * wanted_;
    return state;
}

}  // namespace lampyris::photon_gi
