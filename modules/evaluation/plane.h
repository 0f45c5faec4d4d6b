/// \file One number a pixel, and filters over its neighbourhood.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/display.h"

namespace lampyris::evaluation {

/// Row by row from the top left. Double: SSIM subtracts squares of nearly the same size.
struct Plane {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<double> values;  ///< width · height

    Plane() = default;
    Plane(uint32_t planeWidth, uint32_t planeHeight);
};

/// Luma 0.2126 R + 0.7152 G + 0.0722 B of display values, 0 to 255, not rounded.
[[nodiscard]] Plane lumaOf(const core::DisplayImage& image);

/// Weights exp(−x² / 2σ²) at x = −radius … radius, of sum 1.
[[nodiscard]] std::vector<double> gaussian(double sigma, int radius);

/// Each pixel becomes Σ kernel[i] · its neighbour at i − radius, in its row or its column. Beyond
/// the border the border's pixel is repeated. A kernel has an odd number of weights.
[[nodiscard]] Plane filterRows(const Plane& plane, std::span<const double> kernel);
[[nodiscard]] Plane filterColumns(const Plane& plane, std::span<const double> kernel);

}  // namespace lampyris::evaluation
