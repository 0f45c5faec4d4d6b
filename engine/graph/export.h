/// \file A compiled frame as text: for people (DOT) and for programs (JSON).
#pragma once

#include <string>

#include "graph/compiled.h"
#include "graph/frame.h"

namespace lampyris::graph {

/// A Graphviz digraph: nodes in the order they run, with their barriers; an arrow from the writer
/// of each version to its readers; culled nodes grey, with the reason as tooltip.
[[nodiscard]] std::string toDot(const Frame& frame, const CompiledGraph& graph);

/// Steps with uses and barriers, culled nodes and why, resources with lifetime and place, heaps,
/// and bytes with and without aliasing. Keys are in snake_case, as in the reports.
[[nodiscard]] std::string toJson(const Frame& frame, const CompiledGraph& graph);

}  // namespace lampyris::graph
