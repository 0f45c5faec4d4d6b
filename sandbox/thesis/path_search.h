/// \file The path count that a budget affords.
#pragma once

#include <cstdint>
#include <functional>

#include "core/result.h"

namespace lampyris::sandbox::thesis {

/// Measures what a frame of so many paths costs, in the budget's unit.
using CostOfPaths = std::function<core::Result<double>(uint32_t paths)>;

/// Looks for the count whose cost is the budget, from `guess` on. Measured costs are noisy, so a
/// straight line is laid through all of them, in which near ones weigh more; where it meets the
/// budget is measured next, until it stays where it is. 1 where even one path costs too much.
core::Result<uint32_t> searchPaths(const CostOfPaths& cost, double budget, uint32_t guess);

}  // namespace lampyris::sandbox::thesis
