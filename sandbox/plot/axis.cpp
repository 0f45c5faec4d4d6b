#include "plot/axis.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/check.h"

namespace lampyris::sandbox::plot {
namespace {

constexpr double kSteps = 5.0;    // [chosen] labels that fit beside each other
constexpr double kNearly = 1e-9;  // of a step: what rounding leaves

/// 1, 2 or 5 times a power of ten, at least `least`.
double roundStep(double least) {
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least * (1.0 - kNearly)) return factor * power;
    return 10.0 * power;
}

std::vector<double> linearTicks(Range values) {
    const double step = roundStep((values.high - values.low) / kSteps);
    const double first = std::floor(values.low / step + kNearly);
    const double last = std::ceil(values.high / step - kNearly);
    std::vector<double> ticks(static_cast<size_t>(last - first) + 1);
    for (size_t i = 0; i < ticks.size(); ++i) ticks[i] = (first + static_cast<double>(i)) * step;
    return ticks;
}

/// From the last mark at or below the values to the first at or above them.
std::vector<double> logarithmicTicks(Range values) {
    std::vector<double> ticks;
    for (double power = std::pow(10.0, std::floor(std::log10(values.low)));; power *= 10.0)
        for (const double factor : {1.0, 2.0, 5.0}) {
            const double tick = factor * power;
            if (tick <= values.low * (1.0 + kNearly)) ticks.clear();
            ticks.push_back(tick);
            if (tick >= values.high * (1.0 - kNearly) && ticks.size() > 1) return ticks;
        }
}

}  // namespace

Axis::Axis(Range values, Range pixels, Scale scale) : pixels_(pixels), scale_(scale) {
    const bool logarithmic = scale == Scale::Logarithmic;
    CHECK(values.low <= values.high);
    if (logarithmic) CHECK(values.low > 0.0);
    if (values.low == values.high && !logarithmic) values.high += std::abs(values.low) + 1.0;
    ticks_ = logarithmic ? logarithmicTicks(values) : linearTicks(values);
    values_ = {ticks_.front(), ticks_.back()};
}

double Axis::pixelOf(double value) const {
    const auto place = [&](double v) { return scale_ == Scale::Linear ? v : std::log10(v); };
    const double share =
        (place(value) - place(values_.low)) / (place(values_.high) - place(values_.low));
    return std::lerp(pixels_.low, pixels_.high, share);
}

std::string tickLabel(double value) {
    return fmt::format("{:.6g}", std::abs(value) < 1e-12 ? 0.0 : value);
}

}  // namespace lampyris::sandbox::plot
