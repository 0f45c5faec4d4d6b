/// \file What panels are shown of the last frame. Pointers need to be good for the call alone.
#pragma once

#include "execute/statistics.h"
#include "graph/compiled.h"
#include "graph/frame.h"
#include "photon_gi/renderer.h"
#include "scene/snapshot.h"

namespace lampyris::overlay {

struct FrameSeen {
    const execute::FrameStatistics& statistics;
    const graph::Frame& declared;
    const graph::CompiledGraph& graph;
    const photon_gi::FrameReport& report;
    const accel::AccelCounts& accel;
    const scene::SceneSnapshot& snapshot;
    graph::Extent size{};              ///< pixels
    double overlayMilliseconds = 0.0;  ///< Overlay::cpuMilliseconds()

    [[nodiscard]] double pixels() const { return static_cast<double>(size.width) * size.height; }
};

}  // namespace lampyris::overlay
