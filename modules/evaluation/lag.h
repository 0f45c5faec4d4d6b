/// \file Lag: how long a change of light takes to be seen whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/display.h"
#include "core/result.h"
#include "evaluation/plane.h"

namespace lampyris::evaluation {

constexpr size_t kLagSettled = 64;  ///< the first frame after the change of those averaged
constexpr size_t kLagLast = 96;     ///< and the last

struct Lag {
    /// README [F6]: the first frame after the change whose difference is within a tenth of the
    /// change; none where no frame before kLagSettled is.
    std::optional<uint32_t> frames;
    /// [F5] Mean over pixels of |Y_t − A|, frames 0 to kLagLast. Frame 0 is the last one before the
    /// change: its difference is the whole change.
    std::vector<double> differences;
    /// Mean difference of the settled frames ÷ the whole change: what flicker alone leaves. Near a
    /// tenth and above, the lag says nothing.
    double rest = 0.0;
};

/// Takes frames 0 to kLagLast one after the other; more are not looked at.
class LagMeter {
 public:
    /// Error: the frame is of another size than those before, or has no pixels.
    core::Result<void> add(const core::DisplayImage& frame);

    [[nodiscard]] bool complete() const { return frames_.size() > kLagLast; }
    /// Of a complete sequence. None where the change changes nothing.
    [[nodiscard]] std::optional<Lag> result() const;

 private:
    uint32_t width_ = 0, height_ = 0;
    std::vector<std::vector<float>> frames_;  ///< luma
};

}  // namespace lampyris::evaluation
