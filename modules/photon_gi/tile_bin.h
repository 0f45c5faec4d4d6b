/// \file tile_bin: lists, for every screen tile, the photons whose sphere of influence touches it,
/// in photon order.
///   in      photons, tile bounds          out   ranges (a tile), indices (flat), counters
///   shader  photon_gi/tile_bin_*.comp     theory  README [B1]
///
/// Each photon visits the tiles under its own outline and writes (tile, photon) pairs, photon by
/// photon; the pairs are cut into shares, and counted by tile and share, so that each share knows
/// its places in the tiles' lists. Cost follows the pairs, not tiles times photons.
#pragma once

#include "deferred/tile_bounds.h"
#include "photons/photon_trace.h"

namespace lampyris::photon_gi {

struct TileBins {
    graph::Buffer ranges{};    ///< uvec2 a tile: first index, count
    graph::Buffer indices{};   ///< photon numbers
    graph::Buffer counters{};  ///< shared::FrameCounters
};

struct TileSettings {
    float radiusMetres = 1.0f;
    uint32_t pairCapacity = 0;
};

/// The longest list that a gather may walk: lavapipe ends a shader's loops, unasked and silently,
/// after 65535 turns in all [measured]. A fuller tile makes the frame invalid and its batches
/// smaller.
constexpr uint32_t kMostPhotonsInTile = 60000;

/// Most pairs that can be binned at this size: pairs and counters stay within 128 MiB each.
[[nodiscard]] uint32_t mostPairsBinned(graph::Extent size);

[[nodiscard]] TileBins addTileBin(graph::Frame& frame, const photons::PhotonList& photons,
                                  const deferred::TileBounds& bounds, const shared::View& view,
                                  const TileSettings& settings);

}  // namespace lampyris::photon_gi
