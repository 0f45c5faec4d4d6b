/// \file shadow: one ray a pixel to a random point of each light that reaches it.
///   in  surface, light lists, BVH    out  an image of bits, a layer for 32 lights: set = in shadow
///   shader deferred/shadow.comp
#pragma once

#include "accel/accel_on_gpu.h"
#include "deferred/light_lists.h"

namespace lampyris::deferred {

[[nodiscard]] graph::Image addShadow(graph::Frame& frame, const Surface& surface,
                                     const LightLists& lights, const residency::SceneHandles& scene,
                                     const accel::AccelHandles& accel);

}  // namespace lampyris::deferred
