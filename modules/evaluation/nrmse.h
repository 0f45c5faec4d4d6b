/// \file Root of the mean squared error as a share of the reference's range.
#pragma once

#include "core/result.h"
#include "evaluation/measure.h"
#include "evaluation/picture.h"

namespace lampyris::evaluation {

/// √MSE / (max − min of the reference's 8-bit values over all channels), README [E2]; 0 for equal
/// pictures, and infinity for others where the reference has one value alone. Map: the same of each
/// pixel. Error: pictures of different sizes.
core::Result<Measure> nrmse(const Picture& image, const Picture& reference);

}  // namespace lampyris::evaluation
