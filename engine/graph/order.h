/// \file The order in which nodes run: after those whose versions they read, retire or follow.
#pragma once

#include <cstdint>
#include <vector>

#include "core/result.h"
#include "graph/frame.h"
#include "graph/versions.h"

namespace lampyris::graph {

/// All nodes, culled ones too (an order may hold only through them). Seed 0: of the nodes that may
/// run, the one declared first; else one drawn at random. Error: a cycle, with its nodes and
/// resources.
[[nodiscard]] core::Result<std::vector<uint32_t>> orderNodes(const Frame& frame,
                                                             const Versions& versions,
                                                             uint64_t randomSeed);

}  // namespace lampyris::graph
