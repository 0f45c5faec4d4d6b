/// \file How many paths make one way of drawing cost what another costs.
#pragma once

#include <cstdint>
#include <vector>

#include "core/result.h"
#include "thesis/study.h"

namespace lampyris::sandbox::thesis {

/// What of a frame is compared: photon tracing and radiance estimate, or all of it.
enum class Cost : uint8_t { Indirect, Frame };

/// Two ways of drawing, drawn turn by turn: what slows the machine down slows both.
struct Pair {
    std::vector<Contestant> both;  ///< the yardstick, then the candidate
    [[nodiscard]] Contestant& yardstick() { return both.front(); }
    [[nodiscard]] Contestant& candidate() { return both.back(); }
};

/// Paths a frame with which the candidate costs what the yardstick costs, or what a former run of
/// the study found; see searchPaths(). 1 where the candidate costs more with any.
core::Result<uint32_t> pathsOfEqualCost(Study& study, Pair& pair, Cost cost, uint32_t guess);

}  // namespace lampyris::sandbox::thesis
