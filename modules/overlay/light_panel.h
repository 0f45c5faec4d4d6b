/// \file Photons: what is drawn over the picture of photons, paths, tiles, history and BVH; and
/// their numbers in the last frame.
#pragma once

#include "overlay/frame_seen.h"
#include "overlay/marks.h"

namespace lampyris::overlay {

/// \param split     the paths of the last frame
/// \param settings  of the next one: what it will not have cannot be chosen
void drawLightPanel(const FrameSeen& seen, const photons::PathSplit& split,
                    const photon_gi::Settings& settings, MarkChoice& choice, bool* open);

}  // namespace lampyris::overlay
