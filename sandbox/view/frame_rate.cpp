#include "view/frame_rate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "statistics.h"

namespace lampyris::sandbox::view {

void FrameRate::add(Clock::time_point now) {
    if (last_)
        milliseconds_.push_back(std::chrono::duration<double, std::milli>(now - *last_).count());
    last_ = now;
}

std::string FrameRate::summary() const {
    if (milliseconds_.empty()) return "no two frames followed each other";
    const double all = std::accumulate(milliseconds_.begin(), milliseconds_.end(), 0.0);
    std::vector<double> sorted = milliseconds_;
    std::sort(sorted.begin(), sorted.end());
    const auto rank = static_cast<size_t>(std::ceil(0.99 * static_cast<double>(sorted.size())));
    const auto count = static_cast<double>(sorted.size());
    return fmt::format(
        "{} frames in {:.1f} s, {:.1f} a second; median {:.1f} ms, 99 % within {:.1f}, longest "
        "{:.1f}",
        sorted.size(), all / 1000.0, 1000.0 * count / all, summarise(sorted).median,
        sorted[rank - 1], sorted.back());
}

}  // namespace lampyris::sandbox::view
