#include "evaluation/lag.h"

#include <cmath>

#include "core/check.h"

namespace lampyris::evaluation {
namespace {

constexpr double kWithin = 0.1;  // [eq] README [F6]

std::vector<double> averageOf(const std::vector<std::vector<float>>& frames) {
    std::vector<double> average(frames[0].size(), 0.0);
    for (size_t t = kLagSettled; t <= kLagLast; ++t)
        for (size_t p = 0; p < average.size(); ++p) average[p] += frames[t][p];
    for (double& value : average) value /= static_cast<double>(kLagLast - kLagSettled + 1);
    return average;
}

double meanDifference(const std::vector<float>& frame, const std::vector<double>& average) {
    double sum = 0.0;
    for (size_t p = 0; p < frame.size(); ++p) sum += std::abs(frame[p] - average[p]);
    return sum / static_cast<double>(frame.size());
}

}  // namespace

core::Result<void> LagMeter::add(const core::DisplayImage& frame) {
    if (complete()) return {};
    if (frame.values.empty()) return core::error("a frame has no pixels");
    if (frames_.empty()) {
        width_ = frame.width;
        height_ = frame.height;
    }
    if (frame.width != width_ || frame.height != height_)
        return core::error("frame {} is {}x{}, those before are {}x{}", frames_.size(), frame.width,
                           frame.height, width_, height_);
    const Plane luma = lumaOf(frame);
    frames_.emplace_back(luma.values.begin(), luma.values.end());
    return {};
}

std::optional<Lag> LagMeter::result() const {
    CHECK(complete());
    const std::vector<double> average = averageOf(frames_);
    Lag lag;
    for (const auto& frame : frames_) lag.differences.push_back(meanDifference(frame, average));
    const double whole = lag.differences[0];
    if (!(whole > 0.0)) return std::nullopt;
    for (size_t t = kLagSettled; t <= kLagLast; ++t) lag.rest += lag.differences[t];
    lag.rest /= whole * static_cast<double>(kLagLast - kLagSettled + 1);
    for (uint32_t t = 1; t < kLagSettled && !lag.frames; ++t)
        if (lag.differences[t] <= kWithin * whole) lag.frames = t;
    return lag;
}

}  // namespace lampyris::evaluation
