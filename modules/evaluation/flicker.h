/// \file Flicker of a sequence of pictures: still, moving, and how long a change takes.
#pragma once

#include <span>
#include <vector>

#include "core/result.h"
#include "evaluation/plane.h"

namespace lampyris::evaluation {

/// Of pictures in which nothing moves.                                                         [F1]
struct StaticFlicker {
    double mean = 0.0;  ///< over pixels, of the standard deviation over time; luma, 0 to 255
    double percentile99 = 0.0;   ///< of the pixels
    core::Image map;             ///< the deviation, a channel
    core::DisplayImage average;  ///< over time, rounded: blur cannot pose as calm beside its MSSIM
};

/// Takes pictures one after the other, all of one size.
class StillSequence {
 public:
    core::Result<void> add(const core::DisplayImage& picture);
    [[nodiscard]] uint32_t frames() const { return frames_; }
    /// An error where there are fewer than two pictures.
    [[nodiscard]] core::Result<StaticFlicker> flicker() const;

 private:
    uint32_t frames_ = 0, width_ = 0, height_ = 0;
    std::vector<double> mean_,
        squares_;                 ///< Welford: running mean of luma, sum of squares about it
    std::vector<uint32_t> sums_;  ///< of display values
};

/// A figure, and its part in each frame.
struct FrameFigures {
    double mean = 0.0;
    std::vector<double> frames;
};

/// Mean over frames of |(I_t − I_{t−1}) − (R_t − R_{t−1})| on means of 8 × 8 pixels of luma; the
/// first frame has no part. Errors: fewer than two pictures, not as many references, other sizes.
///                                                                                             [F2]
core::Result<FrameFigures> dynamicFlicker(std::span<const core::DisplayImage> pictures,
                                          std::span<const core::DisplayImage> references);

/// How long a change takes.                                                                    [F3]
struct Lag {
    bool arrives = false;             ///< within the sequence
    uint32_t frames = 0;              ///< after the change
    std::vector<double> differences;  ///< of each picture to the last ones' average
};

constexpr uint32_t kFirstSettled = 64, kLastSettled = 96;  ///< frames after the change

/// \param pictures the last one before the change, then at least kLastSettled after it
core::Result<Lag> lagOf(std::span<const core::DisplayImage> pictures);

}  // namespace lampyris::evaluation
