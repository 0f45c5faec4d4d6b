/// \file The path count that a budget affords.
#pragma once

#include <cstdint>
#include <functional>

#include "core/result.h"

namespace lampyris::sandbox::thesis {

/// Measures what a frame of so many paths costs, in the budget's unit.
using CostOfPaths = std::function<core::Result<double>(uint32_t paths)>;

/// Looks for the count whose cost is within a fiftieth of the budget, from `guess` on, and gives
/// the nearest of those it measured (a dozen at most): costs are noisy, and grow with the paths.
/// 1 where even one path costs too much.
core::Result<uint32_t> searchPaths(const CostOfPaths& cost, double budget, uint32_t guess);

}  // namespace lampyris::sandbox::thesis
