/// \file sphere_direct: direct light of the sphere lights, Lambert and GGX.
///   in      surface, light lists, shadows (or none: every light is seen, as in the Thesis)
///   out     diffuse irradiance W/m² without albedo; specular radiance
///   shader  deferred/sphere_direct*.comp, shadow_edges.comp     theory  README [D1], [D2], [D5]
#pragma once

#include "deferred/shadow.h"

namespace lampyris::deferred {

struct DirectLight {
    graph::Image irradiance{};  ///< RGBA16F, W/m²
    graph::Image specular{};    ///< RGBA16F, W/(m²·sr)
};

/// Every light that reaches a pixel is seen from there.
[[nodiscard]] DirectLight addUnshadowedDirect(graph::Frame& frame, const Surface& surface,
                                              const LightLists& lights,
                                              const residency::SceneHandles& scene, Keep keep);

/// Between the shadows' texels; pixels for which those do not stand trace rays of their own
/// (`shadow/edges`).
[[nodiscard]] DirectLight addSphereDirect(graph::Frame& frame, const Surface& surface,
                                          const LightLists& lights, const Shadows& shadows,
                                          const residency::SceneHandles& scene,
                                          const accel::AccelHandles& accel, Keep keep = Keep::No);

/// The light as the last frame that kept it drew it, at the same size.
[[nodiscard]] DirectLight recallDirect(graph::Frame& frame, graph::Extent size);

}  // namespace lampyris::deferred
