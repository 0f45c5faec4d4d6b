/// \file Mean structural similarity after Wang et al. 2004.
#pragma once

#include <cstdint>

#include "core/result.h"
#include "evaluation/measure.h"
#include "evaluation/picture.h"

namespace lampyris::evaluation {

constexpr uint32_t kSsimWindow = 11;  ///< pixels, a side

/// Mean SSIM of luma of 8-bit values over all windows that lie wholly inside, README [E3]; 1 for
/// equal pictures. Map: SSIM of each window, (width − 10) · (height − 10), from the top left.
/// Errors: pictures of different sizes, or smaller than a window.
core::Result<Measure> mssim(const Picture& image, const Picture& reference);

}  // namespace lampyris::evaluation
