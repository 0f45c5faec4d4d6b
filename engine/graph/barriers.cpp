#include "graph/barriers.h"

namespace lampyris::graph {
namespace {

void addBarriersOf(const ResourceInfo& info, uint32_t resource, const Episodes& episodes,
                   CompiledGraph& graph) {
    TouchSet source;
    Layout layout = openingLayout(info);
    for (size_t i = 0; i < episodes.size(); ++i) {
        const Episode& next = episodes[i];
        // The frame's opening barrier stands before the first episode: only a layout may be
        // missing.
        const bool needed = i > 0 || (info.isImage && layout != next.layout);
        if (needed) {
            Barrier barrier{.resource = resource, .isImage = info.isImage};
            barrier.source = source;
            barrier.destination = next.touches;
            barrier.discards = next.discards;
            barrier.before = next.discards ? Layout::Undefined : layout;
            barrier.after = next.layout;
            const bool after = next.firstStep >= graph.steps.size();
            (after ? graph.finalBarriers : graph.steps[next.firstStep].barriers).push_back(barrier);
        }
        source = next.touches;
        layout = next.layout;
    }
    graph.resources[resource].endLayout = layout;
}

}  // namespace

void addBarriers(const Frame& frame, const std::vector<Episodes>& episodes, CompiledGraph& graph) {
    for (uint32_t resource = 0; resource < episodes.size(); ++resource) {
        addBarriersOf(frame.resources()[resource], resource, episodes[resource], graph);
    }
}

void addHandovers(const std::vector<Tenant>& tenants, const std::vector<Episodes>& episodes,
                  CompiledGraph& graph) {
    for (const Tenant& next : tenants) {
        MemoryBarrier& handover = graph.steps[next.firstStep].handover;
        for (const Tenant& earlier : tenants) {
            if (earlier.lastStep >= next.firstStep || !bytesOverlap(earlier, next)) continue;
            handover.handovers.push_back({earlier.resource, next.resource});
            handover.source.add(episodes[earlier.resource].back().touches);
            handover.destination.add(episodes[next.resource].front().touches);
        }
    }
}

}  // namespace lampyris::graph
