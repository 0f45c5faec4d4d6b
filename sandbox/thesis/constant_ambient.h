/// \file The poor man's indirect light: direct light plus albedo times one constant.
#pragma once

#include <array>

#include "core/display.h"
#include "core/image.h"

namespace lampyris::sandbox::thesis {

/// Irradiance a channel, in W/m².
using AmbientIrradiance = std::array<float, 3>;

/// direct + albedo · irradiance / π.
[[nodiscard]] core::Image withAmbient(const core::Image& direct, const core::Image& albedo,
                                      const AmbientIrradiance& irradiance);

/// The constant that brings display values closest to the reference's in mean square, a channel
/// each; chosen by one who knows the reference, so the best that a constant can do. Looks at every
/// n-th pixel where there are many.
[[nodiscard]] AmbientIrradiance bestAmbient(const core::Image& direct, const core::Image& albedo,
                                            const core::DisplayImage& reference,
                                            const core::DisplayTransform& display);

}  // namespace lampyris::sandbox::thesis
