/// \file grid gather: photons into a grid in the world, which a few rays a texel look up; averaged
/// over frames, filtered and joined to full resolution.
#pragma once

#include "photon_gi/frame.h"
#include "photon_gi/gather.h"

namespace lampyris::photon_gi {

/// \param out takes the batches' ledgers and the paths' importance
[[nodiscard]] JoinedIrradiance addGridGather(graph::Frame& f, const FrameInputs& in,
                                             const Settings& s, const Capacities& room,
                                             const deferred::Surface& surface, DrawnFrame& out);

}  // namespace lampyris::photon_gi
