/// \file What a row of measurements says of one way of drawing: figures by name.
#pragma once

#include <map>
#include <span>
#include <string>

#include "core/display.h"
#include "core/result.h"
#include "evaluation/picture.h"
#include "race.h"

namespace lampyris::sandbox::thesis {

/// Over the frames that were measured.
struct Spread {
    double mean = 0.0;
    double stddev = 0.0;
};
[[nodiscard]] Spread spreadOf(std::span<const double> values);

/// Names below, and those of evaluation::figuresOf().
using Figures = std::map<std::string, Spread>;
constexpr const char* kFrame = "frame_ms";    ///< GPU time
constexpr const char* kStored = "stored";     ///< photons
constexpr const char* kPaths = "paths";       ///< emitted
constexpr const char* kDirect = "direct_ms";  ///< G-buffer, direct light, composite, what moves
constexpr const char* kTrace = "trace_ms";
constexpr const char* kEstimate = "estimate_ms";  ///< all other nodes: the radiance estimate
constexpr const char* kBetween = "between_ms";    ///< of the frame, in no node

/// A row of a table: a way of drawing each, by its name.
using Row = std::map<std::string, Figures>;

/// Costs of a race, split as the Thesis' figures 6.3 and B.1 split them.
[[nodiscard]] Figures costsOf(const Contestant& contestant);

/// Photon tracing and radiance estimate, a frame each.
[[nodiscard]] std::vector<double> indirectMilliseconds(const Contestant& contestant);

/// Errors of pictures against the reference. Error: the pictures are of another size, or hold NaN.
core::Result<Figures> errorsOf(std::span<const core::Image> pictures,
                               const evaluation::Picture& reference,
                               const core::DisplayTransform& display);

}  // namespace lampyris::sandbox::thesis
