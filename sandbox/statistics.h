/// \file Six numbers that stand for a series of measurements.
#pragma once

#include <span>

namespace lampyris::sandbox {

struct Statistics {
    double mean = 0.0;
    double stddev = 0.0;  ///< of the series itself (divided by N)
    double median = 0.0;
    double p95 = 0.0;
    double min = 0.0;
    double max = 0.0;
};

/// Between two ranks, quantiles are interpolated. An empty series gives zeros.
[[nodiscard]] Statistics summarise(std::span<const double> series);

}  // namespace lampyris::sandbox
