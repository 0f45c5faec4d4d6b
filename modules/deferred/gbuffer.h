/// \file gbuffer: the surface under every pixel.
///   in      the scene's draws            out   depth, normal, albedo and roughness, reflectance,
///   emission shader  deferred/gbuffer.vert, .frag  size  24 bytes a pixel (the Thesis: 72)
#pragma once

#include <vector>

#include "deferred/kept.h"
#include "residency/scene_handles.h"
#include "shared/view.h"

namespace lampyris::deferred {

/// Formats and packing stand in shaders/shared/surface.h.
struct Surface {
    graph::Image depth{};     ///< D32, reversed; 0 is background
    graph::Image normal{};    ///< world space, towards the camera
    graph::Image albedo{};    ///< diffuse albedo; a = roughness
    graph::Image specular{};  ///< square root of the reflectance at normal incidence
    graph::Image emission{};  ///< radiance
    shared::View view{};      ///< the camera it was drawn with
};

[[nodiscard]] Surface addGBuffer(graph::Frame& frame, const shared::View& view,
                                 const residency::SceneHandles& scene,
                                 const std::vector<residency::DrawItem>& draws,
                                 Keep keep = Keep::No);

/// The surface as the last frame that kept it drew it; the view must be the same.
[[nodiscard]] Surface recallGBuffer(graph::Frame& frame, const shared::View& view);

/// Binds depth and normal, and the view, where lib/surface.glsl expects them.
void bindSurface(graph::ComputeNode& node, const Surface& surface);
/// The same and the three material images.
void bindSurfaceMaterial(graph::ComputeNode& node, const Surface& surface);

}  // namespace lampyris::deferred
