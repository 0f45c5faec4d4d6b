/// \file composite: all light together, and the lights' own discs: the finished picture.
///   in      surface, direct light, indirect irradiance (or none), lights    out   RGBA16F radiance
///   shader  photon_gi/composite.comp
#pragma once

#include "deferred/sphere_direct.h"

namespace lampyris::photon_gi {

/// \param indirect irradiance; invalid: direct light alone
[[nodiscard]] graph::Image addComposite(graph::Frame& frame, const deferred::Surface& surface,
                                        const deferred::DirectLight& direct, graph::Image indirect,
                                        const deferred::LightLists& lights,
                                        const residency::SceneHandles& scene);

}  // namespace lampyris::photon_gi
