/// \file tile gather: indirect irradiance as in the Thesis, from photons binned to tiles of the
/// screen; `--gather tiles`. The nodes: photon_trace, tile_bin (tile_test), gather, upsample.
#pragma once

#include "deferred/tile_bounds.h"
#include "photon_gi/frame.h"

namespace lampyris::photon_gi {

/// Photons of one batch after the other: traced, binned, gathered; their irradiances add up.
/// \param out receives their ledgers, a batch each, and its insides
[[nodiscard]] JoinedIrradiance addTileGather(graph::Frame& frame, const FrameInputs& in,
                                             const Settings& settings, const Capacities& room,
                                             const deferred::Surface& surface,
                                             const deferred::TileBounds& bounds, DrawnFrame& out);

}  // namespace lampyris::photon_gi
