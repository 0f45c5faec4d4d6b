/// \file LDR-FLIP after Andersson et al. 2020: the difference that an eye sees when it flips
/// between two pictures.
#pragma once

#include "core/result.h"
#include "evaluation/measure.h"
#include "evaluation/picture.h"

namespace lampyris::evaluation {

constexpr double kPixelsPerDegree = 67.0;  ///< 0.7 m before a 0.7 m wide screen of 3840 pixels

/// Mean of FLIP over pixels, of display values, README [E4]; from 0 for equal pictures to 1. Map:
/// FLIP of each pixel. Error: pictures of different sizes.
core::Result<Measure> flip(const Picture& image, const Picture& reference);

}  // namespace lampyris::evaluation
