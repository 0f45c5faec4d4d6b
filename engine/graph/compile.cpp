#include "graph/compile.h"

#include "graph/barriers.h"
#include "graph/cull.h"
#include "graph/episodes.h"
#include "graph/layout_hash.h"
#include "graph/order.h"
#include "graph/place.h"
#include "graph/verify.h"
#include "graph/versions.h"

namespace lampyris::graph {
namespace {

std::vector<Frame::Output> allOutputs(const Frame& frame, const CompileOptions& options) {
    std::vector<Frame::Output> outputs = frame.outputs();
    for (const Image image : options.extraOutputs) {
        outputs.push_back({image.resource, image.version});
    }
    return outputs;
}

/// What each resource is touched for, and when.
std::vector<CompiledResource> summarise(const std::vector<Episodes>& episodes) {
    std::vector<CompiledResource> resources(episodes.size());
    for (size_t resource = 0; resource < episodes.size(); ++resource) {
        if (episodes[resource].empty()) continue;
        CompiledResource& summary = resources[resource];
        summary.firstStep = episodes[resource].front().firstStep;
        summary.lastStep = episodes[resource].back().lastStep;
        for (const Episode& episode : episodes[resource]) {
            summary.accesses.add(episode.touches.accesses());
        }
    }
    return resources;
}

/// The two images of a pair change places, so both must serve for what either does; the executor
/// clears.
void addHistory(const Frame& frame, const std::vector<Episodes>& episodes, CompiledGraph& graph) {
    for (uint32_t resource = 0; resource < frame.resources().size(); ++resource) {
        const ResourceInfo& info = frame.resources()[resource];
        if (info.origin != Origin::History || !info.historyPrevious) continue;
        HistoryPair pair{.previous = resource, .current = info.historyPartner};
        AccessSet both = graph.resources[pair.previous].accesses;
        both.add(graph.resources[pair.current].accesses);
        for (const Access access : {Access::Sampled, Access::TransferRead, Access::TransferWrite}) {
            both.add(access);
        }
        graph.resources[pair.previous].accesses = both;
        graph.resources[pair.current].accesses = both;
        for (const Episode& episode : episodes[pair.current]) {
            pair.currentWritten = pair.currentWritten || episode.writes;
        }
        graph.history.push_back(pair);
    }
}

std::vector<Tenant> findTenants(const Frame& frame, const MemoryModel& memory,
                                const std::vector<CompiledResource>& resources) {
    std::vector<Tenant> tenants;
    for (uint32_t resource = 0; resource < resources.size(); ++resource) {
        const ResourceInfo& info = frame.resources()[resource];
        const CompiledResource& compiled = resources[resource];
        if (info.origin != Origin::Transient || compiled.firstStep == kNoStep) continue;
        tenants.push_back({.resource = resource,
                           .firstStep = compiled.firstStep,
                           .lastStep = compiled.lastStep,
                           .need = info.isImage ? memory.image(info.image, compiled.accesses)
                                                : memory.buffer(info.buffer, compiled.accesses)});
    }
    return tenants;
}

std::vector<Tenant> place(const Frame& frame, const CompileOptions& options, CompiledGraph& graph) {
    const MemoryModel plain;
    const MemoryModel& memory = options.memory != nullptr ? *options.memory : plain;
    std::vector<Tenant> tenants = findTenants(frame, memory, graph.resources);
    graph.heaps = placeTenants(tenants, memory.maxHeapBytes(), options.alias);
    for (const Tenant& tenant : tenants) {
        CompiledResource& compiled = graph.resources[tenant.resource];
        compiled.heap = tenant.heap;
        compiled.offset = tenant.offset;
        compiled.bytes = tenant.need.bytes;
        graph.transientBytesWithoutAliasing += alignUp(tenant.need.bytes, tenant.need.alignment);
    }
    for (const Heap& heap : graph.heaps) graph.transientBytes += heap.bytes;
    return tenants;
}

}  // namespace

core::Result<CompiledGraph> compile(const Frame& frame, const CompileOptions& options) {
    const std::vector<Frame::Output> outputs = allOutputs(frame, options);
    TRY_VOID(verify(frame, outputs));
    const Versions versions(frame);
    TRY(const std::vector<uint32_t> order, orderNodes(frame, versions, options.randomOrderSeed));
    TRY(const Liveness liveness, cullNodes(frame, versions, outputs));
    std::vector<uint32_t> running;
    for (const uint32_t node : order) {
        if (liveness.live[node]) running.push_back(node);
    }
    CompiledGraph graph;
    graph.culled = liveness.culled;
    graph.steps = makeSteps(frame, running, options.poisonTransients);
    const std::vector<Episodes> episodes = findEpisodes(frame, graph.steps, outputs);
    graph.resources = summarise(episodes);
    addHistory(frame, episodes, graph);
    const std::vector<Tenant> tenants = place(frame, options, graph);
    addBarriers(frame, episodes, graph);
    addHandovers(tenants, episodes, graph);
    graph.layoutHash = layoutHash(frame, graph);
    return graph;
}

}  // namespace lampyris::graph
