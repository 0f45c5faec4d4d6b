#include "evaluation/flicker.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace lampyris::evaluation {
namespace {

constexpr double kShare = 0.99;  // [eq] README [F1]

/// The least of the values that this share of them does not exceed.
double percentile(std::vector<float> values, double share) {
    const auto count = static_cast<double>(values.size());
    const auto rank = static_cast<size_t>(std::max(std::ceil(share * count), 1.0)) - 1;
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

core::DisplayImage averageOf(const Plane& like, const std::vector<double>& sum, double frames) {
    core::DisplayImage average{like.width, like.height, std::vector<uint8_t>(sum.size())};
    for (size_t i = 0; i < sum.size(); ++i)
        average.values[i] = static_cast<uint8_t>(std::lround(sum[i] / frames));
    return average;
}

}  // namespace

core::Result<void> FlickerMeter::add(const core::DisplayImage& frame) {
    if (frame.values.empty()) return core::error("a frame has no pixels");
    if (changes_.empty()) {
        mean_ = squares_ = last_ = Plane(frame.width, frame.height);
        sum_.assign(frame.values.size(), 0.0);
    }
    if (frame.width != mean_.width || frame.height != mean_.height)
        return core::error("frame {} is {}x{}, those before are {}x{}", frames(), frame.width,
                           frame.height, mean_.width, mean_.height);
    for (size_t i = 0; i < sum_.size(); ++i) sum_[i] += frame.values[i];
    Plane luma = lumaOf(frame);
    const bool first = changes_.empty();
    const double count = static_cast<double>(frames()) + 1.0;
    double change = 0.0;
    for (size_t p = 0; p < luma.values.size(); ++p) {
        const double y = luma.values[p];
        const double step = y - mean_.values[p];
        mean_.values[p] += step / count;
        squares_.values[p] += step * (y - mean_.values[p]);
        change += first ? 0.0 : std::abs(y - last_.values[p]);
    }
    changes_.push_back(change / static_cast<double>(luma.values.size()));
    last_ = std::move(luma);
    return {};
}

StaticFlicker FlickerMeter::result() const {
    CHECK(frames() > 0u);
    const auto count = static_cast<double>(frames());
    StaticFlicker flicker{0.0, 0.0, core::Image(mean_.width, mean_.height, 1),
                          averageOf(mean_, sum_, count)};
    for (size_t p = 0; p < squares_.values.size(); ++p) {
        const double deviation = std::sqrt(squares_.values[p] / count);
        flicker.map.values[p] = static_cast<float>(deviation);
        flicker.mean += deviation;
    }
    flicker.mean /= static_cast<double>(squares_.values.size());
    flicker.percentile99 = percentile(flicker.map.values, kShare);
    return flicker;
}

}  // namespace lampyris::evaluation
