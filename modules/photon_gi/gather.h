/// \file gather: irradiance from the photons of each tile, at low resolution and at the pixels it
/// fails.
///   in      surface, photons, tile bins    out   coarse irradiance; estimates of the listed pixels
///   shader  photon_gi/gather*.comp, upsample_recompute.comp     theory  README [G1], [G2]
#pragma once

#include "deferred/gbuffer.h"
#include "photon_gi/tile_bin.h"

namespace lampyris::photon_gi {

struct GatherSettings {
    float radiusMetres = 1.0f;
    uint32_t divisor = 2;  ///< low resolution, an axis
};

/// Pixels that the low-resolution texels around them cannot stand for.
struct EdgeList {
    graph::Buffer list{};      ///< the pixels, x | y << 16
    graph::Buffer groups{};    ///< indirect dispatch over the list
    graph::Buffer counters{};  ///< shared::FrameCounters
};

/// Irradiance in W/m² without albedo, summed over the batches so far.
struct Gathered {
    graph::Image coarse{};      ///< RGBA32F, a texel for divisor × divisor pixels
    graph::Buffer estimates{};  ///< vec4 for each listed pixel
};

/// Indirect irradiance at full resolution.
struct JoinedIrradiance {
    graph::Image irradiance{};  ///< RGBA16F, W/m²
    EdgeList edges;             ///< pixels that the texels beside them do not stand for
};

/// A frame's counters, zero.
[[nodiscard]] graph::Buffer clearedCounters(graph::Frame& frame);

[[nodiscard]] EdgeList addEdges(graph::Frame& frame, const deferred::Surface& surface,
                                graph::Buffer counters, const GatherSettings& settings);

/// An indirect dispatch over the pixels listed so far.
[[nodiscard]] graph::Buffer addEdgeGroups(graph::Frame& frame, graph::Buffer counters);

/// \param before what earlier batches gathered, or invalid handles
[[nodiscard]] Gathered addGather(graph::Frame& frame, const deferred::Surface& surface,
                                 const photons::PhotonList& photons, const TileBins& bins,
                                 const EdgeList& edges, const GatherSettings& settings,
                                 const Gathered& before);

/// The low-resolution size of a view.
[[nodiscard]] graph::Extent coarseSize(const shared::View& view, uint32_t divisor);

/// Blocks of pixels between four low-resolution texels each: one more than texels, an axis
/// (lib/coarse_block.glsl).
[[nodiscard]] graph::Extent coarseBlocks(const shared::View& view, uint32_t divisor);

}  // namespace lampyris::photon_gi
