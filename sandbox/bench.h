/// \file The project's measurements, a function each; `lampyris bench NAME` calls one.
#pragma once

#include <filesystem>

#include "core/result.h"
#include "frame_loop.h"
#include "frame_series.h"
#include "options.h"

namespace lampyris::sandbox {

struct BenchCall {
    Options options;            ///< what is left empty is the benchmark's own choice
    std::filesystem::path out;  ///< a folder; empty: print alone
    bool quick = false;         ///< smaller and fewer
};

core::Result<void> benchNodes(
    const BenchCall& call);  ///< frame rate and every node, both pipelines
core::Result<void> benchBinning(const BenchCall& call);  ///< photons to tiles: full beside thesis
core::Result<void> benchRays(const BenchCall& call);     ///< the shader's traversal beside Embree's
core::Result<void> benchAccel(const BenchCall& call);    ///< BVH builds and memory, a scene each

/// One of several ways of drawing, measured turn by turn with the others.
struct Contestant {
    std::string name;
    Options options;
    FrameSeries series;
    photon_gi::FrameReport report;  ///< of the last frame
    graph::Extent size;
    std::string device;
};

/// Draws `warmup` frames and then `frames` of each, turn by turn, so that a machine that slows down
/// slows all. Each has a device of its own: nothing is made anew between turns.
core::Result<void> race(std::vector<Contestant>& contestants, uint32_t warmup, uint32_t frames);

}  // namespace lampyris::sandbox
