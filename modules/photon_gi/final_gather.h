/// \file final gather: indirect irradiance by a few rays a texel into the irradiance grid, filtered
/// and joined to full resolution.
///   in      surface, irradiance grid, BVH       out   irradiance, W/m², and the pixels done anew
///   shader  photon_gi/final_*.comp              theory  README [F1] to [F4]
#pragma once

#include "photon_gi/gather.h"
#include "photons/irradiance_grid.h"

namespace lampyris::photon_gi {

struct FinalGatherSettings {
    uint32_t divisor;       ///< low resolution, an axis
    uint32_t rays;          ///< a texel
    uint32_t filterLevels;  ///< of the à-trous filter; 0: none
    uint32_t seed;          ///< of this frame
};

/// Irradiance at low resolution, and where its texels stand.
struct CoarseIrradiance {
    graph::Image irradiance{};  ///< W/m², a texel for divisor × divisor pixels; a = frames in it
    graph::Image guide{};       ///< RGBA32Uint: position as float bits, normal octahedral
};

/// What rays are traced through.
struct GatherWorld {
    const residency::SceneHandles& scene;
    const accel::AccelHandles& accel;
    photons::IrradianceGrid grid;
};

[[nodiscard]] CoarseIrradiance addFinalGather(graph::Frame& frame, const deferred::Surface& surface,
                                              const GatherWorld& world,
                                              const FinalGatherSettings& settings);

/// What earlier frames of the same low resolution left.
struct GatherPast {
    graph::HistoryImage mean;   ///< RGBA32F: irradiance, frames in it
    graph::HistoryImage guide;  ///< as CoarseIrradiance::guide
    glm::mat4 worldToClipBefore{1.0f};
    uint32_t frames = 0;  ///< most that the mean may hold besides this one; 0: it begins anew
};

/// The mean over frames at each texel's place in the world. Writes both images of `past`.
[[nodiscard]] CoarseIrradiance addFinalHistory(graph::Frame& frame,
                                               const deferred::Surface& surface,
                                               const CoarseIrradiance& newest,
                                               const GatherPast& past,
                                               const FinalGatherSettings& settings);

[[nodiscard]] CoarseIrradiance addFinalFilter(graph::Frame& frame, const deferred::Surface& surface,
                                              CoarseIrradiance coarse,
                                              const FinalGatherSettings& settings);

struct JoinedIrradiance {
    graph::Image irradiance{};  ///< RGBA16F, W/m², full resolution
    EdgeList edges;             ///< pixels that the texels beside them do not stand for
};

/// \param counters shared::FrameCounters
[[nodiscard]] JoinedIrradiance addFinalUpsample(
    graph::Frame& frame, const deferred::Surface& surface, const GatherWorld& world,
    const CoarseIrradiance& coarse, graph::Buffer counters, const FinalGatherSettings& settings);

}  // namespace lampyris::photon_gi
