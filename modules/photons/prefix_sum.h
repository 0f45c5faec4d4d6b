/// \file prefix sum: exclusive sums of counts on the device, with no read-back.
///   in  uint counts    out  the sum before each, then the total
///   shader photons/prefix_sum_blocks.comp, prefix_sum_totals.comp, prefix_sum_add.comp
#pragma once

#include <string>

#include "graph/frame.h"

namespace lampyris::photons {

/// \param node the report's name of what this is part of ("tile_bin")
/// \return count + 1 uints
[[nodiscard]] graph::Buffer addPrefixSum(graph::Frame& frame, const std::string& node,
                                         graph::Buffer counts, uint32_t count);

}  // namespace lampyris::photons
