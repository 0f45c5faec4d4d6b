/// \file Which nodes run: those that lead to an output, to something that outlives the frame, or
/// are kept.
#pragma once

#include <cstdint>
#include <vector>

#include "core/result.h"
#include "graph/frame.h"
#include "graph/versions.h"

namespace lampyris::graph {

struct Liveness {
    std::vector<bool> live;          ///< a node
    std::vector<CulledNode> culled;  ///< the others, in declaration order
};

/// `outputs` are Frame::outputs() and whatever else is asked for. Error: an output that a live node
/// rewrites, so that it is gone when the frame ends.
[[nodiscard]] core::Result<Liveness> cullNodes(const Frame& frame, const Versions& versions,
                                               const std::vector<Frame::Output>& outputs);

}  // namespace lampyris::graph
