/// \file Static flicker: how much a picture trembles while nothing moves.
#pragma once

#include <cstddef>
#include <vector>

#include "core/display.h"
#include "core/image.h"
#include "core/result.h"
#include "evaluation/plane.h"

namespace lampyris::evaluation {

struct StaticFlicker {
    double mean = 0.0;           ///< of the map over pixels, README [F1]
    double percentile99 = 0.0;   ///< of the map: the least value that 99 % of the pixels keep to
    core::Image map;             ///< [F1] standard deviation over time, one channel, luma 0 to 255
    core::DisplayImage average;  ///< [F2] over time, of display values
};

/// Takes the frames of a sequence one after the other, and keeps none.
class FlickerMeter {
 public:
    /// Error: the frame is of another size than those before, or has no pixels.
    core::Result<void> add(const core::DisplayImage& frame);

    [[nodiscard]] size_t frames() const { return changes_.size(); }
    /// [F3] Mean over pixels of |Y_t − Y_{t−1}|, a frame each; the first is 0.
    [[nodiscard]] const std::vector<double>& changes() const { return changes_; }
    /// Of the frames so far; of one frame, it is 0.
    [[nodiscard]] StaticFlicker result() const;

 private:
    Plane mean_, squares_;     ///< of luma over time: its mean, and the sum of squares about it
    Plane last_;               ///< luma of the last frame
    std::vector<double> sum_;  ///< of display values, a channel each
    std::vector<double> changes_;
};

}  // namespace lampyris::evaluation
