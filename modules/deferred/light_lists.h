/// \file light lists: how far each light reaches, and which lights each tile must look at.
///   in      surface, tile bounds, lights     out   reach, masks
///   shader  deferred/light_reach.comp, deferred/light_cull.comp     theory  README [D3]
#pragma once

#include "deferred/gbuffer.h"
#include "deferred/tile_bounds.h"
#include "shared/direct.h"

namespace lampyris::deferred {

struct LightLists {
    graph::Buffer reach{};  ///< metres a light, then three floats: the watts cut off, r, g, b
    graph::Buffer
        masks;  ///< a tile: `maskWords` of lights that reach it, `maskWords` of discs it may show
    shared::DirectParams params;
};

/// \param cutoff of the frame's mean direct irradiance, under which a light is left out; 0: none is
/// \param seed for the shadow rays
[[nodiscard]] LightLists addLightLists(graph::Frame& frame, const Surface& surface,
                                       const TileBounds& bounds,
                                       const residency::SceneHandles& scene, float cutoff,
                                       uint32_t seed);

}  // namespace lampyris::deferred
