/// \file sphere_direct: direct light of the sphere lights, Lambert and GGX.
///   in      surface, light lists, shadow masks (or none: every light is seen, as in the Thesis)
///   out     diffuse irradiance W/m² without albedo; specular radiance
///   shader  deferred/sphere_direct.comp     theory  README [D1], [D2]
#pragma once

#include "deferred/light_lists.h"

namespace lampyris::deferred {

struct DirectLight {
    graph::Image irradiance{};  ///< RGBA16F, W/m²
    graph::Image specular{};    ///< RGBA16F, W/(m²·sr)
};

/// \param shadowMasks invalid: no shadows
[[nodiscard]] DirectLight addSphereDirect(graph::Frame& frame, const Surface& surface,
                                          const LightLists& lights, graph::Image shadowMasks,
                                          const residency::SceneHandles& scene);

}  // namespace lampyris::deferred
