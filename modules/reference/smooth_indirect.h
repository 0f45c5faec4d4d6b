/// \file Indirect irradiance averaged along surfaces: less noise than samples alone can reach.
#pragma once

#include <cstdint>
#include <vector>

#include "core/image.h"
#include "reference/surface_discs.h"

namespace lampyris::reference {

/// Fits a surface of second degree to the irradiance of a pixel's neighbours on the same plane, for
/// one disc of pixels after the other. The largest disc counts whose fit agrees with those of all
/// smaller ones within their errors (intersection of confidence intervals, Goldenshluger and
/// Nemirovski 1997): where light varies, little is averaged. Neighbours then agree on a common
/// size, as a choice that jumps from pixel to pixel would itself be noise. The images are of three
/// channels; the answer's pixels without surface are 0.
[[nodiscard]] core::Image smoothIndirect(const core::Image& irradiance,
                                         const std::vector<SmoothGuide>& guides, uint32_t threads);

}  // namespace lampyris::reference
