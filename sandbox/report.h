/// \file report.json, as DESIGN.md has it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "frame_loop.h"
#include "frame_series.h"

namespace lampyris::sandbox {

/// What the measured frames of a run left.
struct Measured {
    FrameSeries series;
    LoopFrame last;
    uint64_t rebuilds = 0;
    std::vector<double> rebuildMilliseconds;  ///< a frame that rebuilt, each
    uint64_t refits = 0;
    std::vector<double> refitMilliseconds;  ///< a frame that refitted, each
    double sahRatioMax = 1.0;

    void add(LoopFrame frame);
};

/// What a frame is made with, as the report has it.
[[nodiscard]] nlohmann::ordered_json settingsJson(const Options& options);

/// Pretty-printed JSON text.
[[nodiscard]] std::string makeReport(const Options& options, FrameLoop& loop,
                                     const Measured& measured);

}  // namespace lampyris::sandbox
