/// \file Indirect irradiance averaged along surfaces: less noise than samples alone can reach.
#pragma once

#include <cstdint>
#include <vector>

#include "core/image.h"
#include "math/glm.h"

namespace lampyris::reference {

/// Where a pixel's surface stands.
struct SmoothGuide {
    glm::vec3 position{0.0f};      ///< metres, world
    glm::vec3 normal{0.0f};        ///< unit
    float footprintMetres = 0.0f;  ///< a pixel's width there
    float variance = 0.0f;         ///< of the pixel's irradiance, mean of the channels
    uint32_t instance = 0;
    bool surface = false;
};

/// Fits a plane to the irradiance of a pixel's neighbours on the same surface (same instance,
/// normal within 8 degrees, within a pixel's width of the tangent plane), for one disc of pixels
/// after the other, each larger than the last. The largest disc counts whose fit agrees with those
/// of all smaller ones within their errors (intersection of confidence intervals, Goldenshluger and
/// Nemirovski 1997): where light varies, hardly anything is averaged. The images are of three
/// channels; the answer's pixels without surface are 0.
[[nodiscard]] core::Image smoothIndirect(const core::Image& irradiance,
                                         const std::vector<SmoothGuide>& guides,
                                         uint32_t threads);

}  // namespace lampyris::reference
