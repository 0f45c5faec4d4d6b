/// \file composite: all light together, and the lights' own discs: the finished picture.
///   in      surface, direct light, indirect irradiance (or none), lights    out   RGBA16F radiance
///   shader  photon_gi/composite.comp
#pragma once

#include "deferred/sphere_direct.h"

namespace lampyris::photon_gi {

constexpr const char* kFinal = "final";  ///< the picture's public name

/// \param indirect irradiance; invalid: direct light alone
[[nodiscard]] graph::Image addComposite(graph::Frame& frame, const deferred::Surface& surface,
                                        const deferred::DirectLight& direct, graph::Image indirect,
                                        const deferred::LightLists& lights,
                                        const residency::SceneHandles& scene,
                                        deferred::Keep keep = deferred::Keep::No);

/// The picture as the last frame that kept it drew it, at the same size.
[[nodiscard]] graph::Image recallFinal(graph::Frame& frame, graph::Extent size);

}  // namespace lampyris::photon_gi
