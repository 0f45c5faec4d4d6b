/// \file All measures of two pictures at once.
#pragma once

#include <array>

#include "core/display.h"
#include "core/result.h"
#include "evaluation/measure.h"
#include "evaluation/picture.h"

namespace lampyris::evaluation {

struct Comparison {
    Measure mse, nrmse, mssim, flip, relMse;
};

struct Figure {
    const char* name;
    double value;
};

/// Errors: pictures of different sizes, or smaller than SSIM's window.
core::Result<Comparison> compare(const Picture& image, const Picture& reference);

/// MSE, NRMSE, MSSIM, FLIP, relMSE, as they are printed.
[[nodiscard]] std::array<Figure, 5> figuresOf(const Comparison& comparison);

/// Three heat maps from left to right, each of the pictures' size: root of the mean squared
/// difference over the channels, brightest at 64 of 255; 1 − SSIM, with a black border where no
/// window's centre lies; FLIP. Black is equal.
[[nodiscard]] core::DisplayImage drawMaps(const Comparison& comparison);

}  // namespace lampyris::evaluation
