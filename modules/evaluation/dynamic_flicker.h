/// \file Dynamic flicker: what of a moving picture's changes is not the motion's.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/display.h"
#include "core/result.h"

namespace lampyris::evaluation {

constexpr uint32_t kFlickerBlock = 8;        ///< pixels, a side
constexpr double kLargestFloorShare = 0.25;  ///< of the figure, below which it is not void

struct DynamicFlicker {
    double value = 0.0;           ///< README [F4]: mean of the changes
    std::vector<double> changes;  ///< of frames 1, 2, …: mean over blocks
    [[nodiscard]] bool valid(double floor) const { return floor < kLargestFloorShare * value; }
};

/// Mean over frames and blocks of 8x8 pixels of |(I_t − I_{t−1}) − (R_t − R_{t−1})|; a block at the
/// right or lower border is of what pixels there are. Between two seeds of R, it is the floor.
/// Errors: as many frames as references, two at least, all of one size.
core::Result<DynamicFlicker> dynamicFlicker(std::span<const core::DisplayImage> frames,
                                            std::span<const core::DisplayImage> references);

}  // namespace lampyris::evaluation
