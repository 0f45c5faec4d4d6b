/// \file Several ways of drawing, measured turn by turn.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/image.h"
#include "core/result.h"
#include "frame_loop.h"
#include "frame_series.h"
#include "options.h"

namespace lampyris::sandbox {

/// One of several ways of drawing, and what the last race measured of it.
struct Contestant {
    std::string name;
    Options options{};  ///< photons, radius and what else makes settings may change between races
    std::shared_ptr<FrameLoop> loop{};  ///< opened by the first race, and kept for the next
    FrameSeries series{};
    std::vector<double> photonsStored{};  ///< a frame each
    std::vector<core::Image> pictures{};  ///< of the last frames
    photon_gi::FrameReport report{};      ///< of the last frame
    graph::Extent size{};
    std::string device{};
};

struct RaceLength {
    uint32_t warmup = 0;
    uint32_t frames = 1;
    uint32_t pictures = 0;       ///< of the last frames, read back outside their timed range
    std::string what = "frame";  ///< as progress calls it
};

/// Its loop, opened where it is not.
core::Result<FrameLoop*> loopOf(Contestant& contestant);

/// Draws frames of each, turn by turn, so that a machine that slows down slows all. Each has a
/// device of its own: nothing is made anew between turns.
core::Result<void> race(std::vector<Contestant>& contestants, const RaceLength& length);

}  // namespace lampyris::sandbox
