/// \file Mean squared error of display values.
#pragma once

#include "core/result.h"
#include "evaluation/measure.h"
#include "evaluation/picture.h"

namespace lampyris::evaluation {

/// Mean of (image − reference)² over pixels and channels, of 8-bit values, README [E1]. Map: the
/// mean over the channels of each pixel. Error: pictures of different sizes.
core::Result<Measure> mse(const Picture& image, const Picture& reference);

}  // namespace lampyris::evaluation
