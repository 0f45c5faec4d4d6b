#include "statistics.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lampyris::sandbox {
namespace {

double quantile(std::span<const double> sorted, double share) {
    const double rank = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<size_t>(rank);
    const size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], rank - static_cast<double>(below));
}

}  // namespace

Statistics summarise(std::span<const double> series) {
    if (series.empty()) return {};
    std::vector<double> sorted(series.begin(), series.end());
    std::sort(sorted.begin(), sorted.end());
    const auto count = static_cast<double>(sorted.size());
    double sum = 0.0;
    for (const double value : sorted) sum += value;
    const double mean = sum / count;
    double squares = 0.0;
    for (const double value : sorted) squares += (value - mean) * (value - mean);
    return {.mean = mean,
            .stddev = std::sqrt(squares / count),
            .median = quantile(sorted, 0.5),
            .p95 = quantile(sorted, 0.95),
            .min = sorted.front(),
            .max = sorted.back()};
}

}  // namespace lampyris::sandbox
