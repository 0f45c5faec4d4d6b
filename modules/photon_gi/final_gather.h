/// \file final gather: indirect irradiance by a few rays a texel into the irradiance grid, filtered
/// and joined to full resolution.
///   in      surface, irradiance grid, BVH       out   irradiance, W/m², and the pixels done anew
///   shader  photon_gi/final_*.comp              theory  README [F1] to [F7]
#pragma once

#include "photon_gi/gather.h"
#include "photons/irradiance_grid.h"
#include "shared/tile_bin.h"

namespace lampyris::photon_gi {

struct FinalGatherSettings {
    uint32_t divisor;       ///< low resolution, an axis
    uint32_t rays;          ///< a texel
    uint32_t filterLevels;  ///< of the à-trous filter; 0: none
    uint32_t seed;          ///< of all frames
    uint32_t turn;          ///< this frame's number; 0 where frames are all alike
};

/// Light at low resolution, and where its texels stand.
struct CoarseIrradiance {
    graph::Image irradiance{};  ///< RGBA32Uint, a texel for divisor × divisor pixels: as in
                                ///< lib/coarse_light.glsl, W/m²
    graph::Image guide{};  ///< RGBA32Uint: position as float bits, the geometry's normal octahedral
    graph::Image mean{};   ///< of what comes out of the history: RGBA32F, a = frames in it
};

/// \param step filter: texels between two taps
[[nodiscard]] shared::GatherParams finalParams(const shared::View& view,
                                               const FinalGatherSettings& settings,
                                               uint32_t step = 1);
void bindCoarse(graph::ComputeNode& node, const CoarseIrradiance& coarse);

/// What rays are traced through.
struct GatherWorld {
    const residency::SceneHandles& scene;
    const accel::AccelHandles& accel;
    photons::IrradianceGrid grid;
};

struct FinalGathered {
    CoarseIrradiance coarse;
    graph::Buffer lookUps{};  ///< how often each slot of the grid was looked up
};

[[nodiscard]] FinalGathered addFinalGather(graph::Frame& frame, const deferred::Surface& surface,
                                           const GatherWorld& world,
                                           const FinalGatherSettings& settings);

[[nodiscard]] CoarseIrradiance addFinalFilter(graph::Frame& frame, const deferred::Surface& surface,
                                              CoarseIrradiance coarse,
                                              const FinalGatherSettings& settings);

/// \param counters shared::FrameCounters
[[nodiscard]] JoinedIrradiance addFinalUpsample(
    graph::Frame& frame, const deferred::Surface& surface, const GatherWorld& world,
    const CoarseIrradiance& coarse, graph::Buffer counters, const FinalGatherSettings& settings);

}  // namespace lampyris::photon_gi
