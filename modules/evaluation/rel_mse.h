/// \file Relative mean squared error of linear light.
#pragma once

#include "core/result.h"
#include "evaluation/measure.h"
#include "evaluation/picture.h"

namespace lampyris::evaluation {

/// Mean of (image − reference)² / (reference² + 0.01) over pixels and channels, of linear values
/// without exposure, README [E5]. Map: the mean over the channels of each pixel. Error: pictures of
/// different sizes.
core::Result<Measure> relMse(const Picture& image, const Picture& reference);

}  // namespace lampyris::evaluation
