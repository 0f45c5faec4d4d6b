/// \file Maps of measures as pictures.
#pragma once

#include <span>

#include "core/display.h"
#include "core/image.h"

namespace lampyris::evaluation {

/// Black for 0 and less over violet, red and orange to pale yellow for `brightest` and more, ever
/// brighter on the way. `values` has one channel.
[[nodiscard]] core::DisplayImage heatMap(const core::Image& values, float brightest);

/// In the middle of a black picture of that size, which is no smaller.
[[nodiscard]] core::DisplayImage centred(const core::DisplayImage& image, uint32_t width,
                                         uint32_t height);

/// From left to right. All have the same height.
[[nodiscard]] core::DisplayImage sideBySide(std::span<const core::DisplayImage> images);

}  // namespace lampyris::evaluation
