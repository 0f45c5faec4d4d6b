/// \file Barriers from episodes, and memory barriers where bytes pass from one transient to the
/// next.
#pragma once

#include <vector>

#include "graph/compiled.h"
#include "graph/episodes.h"
#include "graph/place.h"

namespace lampyris::graph {

/// Fills in each step's barriers, the final ones, and the images' endLayout.
void addBarriers(const Frame& frame, const std::vector<Episodes>& episodes, CompiledGraph& graph);

/// Fills in each step's handover: against every earlier user of the memory, not the latest alone,
/// since the latest may have covered only a part.
void addHandovers(const std::vector<Tenant>& tenants, const std::vector<Episodes>& episodes,
                  CompiledGraph& graph);

}  // namespace lampyris::graph
