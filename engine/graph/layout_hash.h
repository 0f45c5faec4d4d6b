/// \file A number that changes whenever the executor must make its transients anew.
#pragma once

#include <cstdint>

#include "graph/compiled.h"
#include "graph/frame.h"

namespace lampyris::graph {

/// Of heaps, and of every placed resource in turn: its name, description, accesses, and place. Not
/// of its index: a frame that imports one buffer more keeps its transients.
[[nodiscard]] uint64_t layoutHash(const Frame& frame, const CompiledGraph& graph);

}  // namespace lampyris::graph
