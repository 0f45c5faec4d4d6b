/// \file How often frames came, by the wall clock.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace lampyris::sandbox::view {

class FrameRate {
 public:
    using Clock = std::chrono::steady_clock;

    /// A frame has been shown.
    void add(Clock::time_point now);
    /// The next frame follows none: what lies between was no frame's time.
    void interrupt() { last_.reset(); }

    [[nodiscard]] size_t frames() const { return milliseconds_.size(); }
    /// "600 frames in 30.0 s, 20.0 a second; median 49.8 ms, 99 % within 61.2, longest 80.1".
    [[nodiscard]] std::string summary() const;

 private:
    std::optional<Clock::time_point> last_;
    std::vector<double> milliseconds_;  ///< from one frame to the next
};

}  // namespace lampyris::sandbox::view
