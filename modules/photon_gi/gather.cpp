#include "photon_gi/gather.h"

#include <algorithm>

#include "photon_gi/shaders.h"
#include "shared/tile_bin.h"

namespace lampyris::photon_gi {
namespace {

// [eq] Thesis listing 5.18.
constexpr float kNormalLimit = 0.99f;
/// Vulkan's guaranteed maxComputeWorkGroupCount, an axis.
constexpr uint32_t kMostGroups = 65535;

shared::GatherParams gatherParams(const shared::View& view, const GatherSettings& settings,
                                  float powerScale) {
    const graph::Extent coarse = coarseSize(view, settings.divisor);
    return {settings.radiusMetres,
            powerScale,
            settings.divisor,
            coarse.width,
            coarse.height,
            0,
            0,
            kNormalLimit,
            0,
            0,
            0,
            0,
            0,
            0,
            0,
            0};
}

void bindEstimate(graph::ComputeNode& node, const deferred::Surface& surface,
                  const photons::PhotonList& photons, const TileBins& bins,
                  const GatherSettings& settings) {
    deferred::bindSurface(node, surface);
    node.texels(shared::SLOT_BIN_PHOTONS, photons.photons, graph::Format::RGBA32Uint)
        .texels(shared::SLOT_GATHER_INDICES, bins.indices, graph::Format::R32Uint)
        .read(shared::SLOT_BIN_RANGES, bins.ranges)
        .push(gatherParams(surface.view, settings, photons.powerScale));
}

graph::Image addCoarse(graph::Frame& frame, const deferred::Surface& surface,
                       const photons::PhotonList& photons, const TileBins& bins,
                       const GatherSettings& settings, graph::Image before) {
    const graph::Extent size = coarseSize(surface.view, settings.divisor);
    const bool first = !before.valid();
    auto node = frame.compute("gather", first ? shaders::gather : shaders::gatherAdd);
    bindEstimate(node, surface, photons, bins, settings);
    const graph::Image coarse =
        first ? node.write(shared::SLOT_GATHER_COARSE,
                           frame.image("coarse irradiance", {graph::Format::RGBA32Float, size}))
              : node.update(shared::SLOT_GATHER_COARSE, before);
    // Whole tiles, so that neighbouring threads share one: see texelOfThread in gather.comp.
    const uint32_t perAxis = std::max(shared::TILE_PIXELS / settings.divisor, 1u);
    const graph::Extent tiles = size.dividedBy(perAxis);
    const uint32_t groups = (tiles.width * tiles.height * perAxis * perAxis + 63) / 64;
    const uint32_t rows = (groups + kMostGroups - 1) / kMostGroups;
    node.dispatch((groups + rows - 1) / rows, rows);
    return coarse;
}

graph::Buffer addEstimates(graph::Frame& frame, const deferred::Surface& surface,
                           const photons::PhotonList& photons, const TileBins& bins,
                           const EdgeList& edges, const GatherSettings& settings,
                           graph::Buffer before) {
    const bool first = !before.valid();
    auto node = frame.compute("upsample/recompute",
                              first ? shaders::upsampleRecompute : shaders::upsampleRecomputeAdd);
    bindEstimate(node, surface, photons, bins, settings);
    node.read(shared::SLOT_GATHER_COUNTERS, edges.counters)
        .read(shared::SLOT_GATHER_LIST, edges.list);
    const uint64_t bytes =
        uint64_t{surface.view.width} * surface.view.height * sizeof(shared::vec4);
    const graph::Buffer estimates =
        first ? node.write(shared::SLOT_GATHER_ESTIMATES, frame.buffer("edge estimates", {bytes}))
              : node.update(shared::SLOT_GATHER_ESTIMATES, before);
    node.dispatchIndirect(edges.groups);
    return estimates;
}

}  // namespace

graph::Extent coarseSize(const shared::View& view, uint32_t divisor) {
    return graph::Extent{view.width, view.height}.dividedBy(divisor);
}

graph::Extent coarseBlocks(const shared::View& view, uint32_t divisor) {
    const graph::Extent size = coarseSize(view, divisor);
    return {size.width + 1, size.height + 1};
}

graph::Buffer clearedCounters(graph::Frame& frame) {
    auto clear = frame.transfer("gather/clear");
    return clear.fill(frame.buffer("frame counters", {sizeof(shared::FrameCounters)}), 0);
}

EdgeList addEdges(graph::Frame& frame, const deferred::Surface& surface, graph::Buffer counters,
                  const GatherSettings& settings) {
    const uint64_t pixels = uint64_t{surface.view.width} * surface.view.height;
    EdgeList list;
    auto find = frame.compute("gather/edges", shaders::gatherEdges);
    deferred::bindSurface(find, surface);
    find.push(gatherParams(surface.view, settings, 1.0f));
    list.list = find.write(shared::SLOT_GATHER_LIST,
                           frame.buffer("edge list", {pixels * sizeof(uint32_t)}));
    list.counters = find.update(shared::SLOT_GATHER_COUNTERS, counters);
    find.dispatchOver(coarseBlocks(surface.view, settings.divisor));

    list.groups = addEdgeGroups(frame, list.counters);
    return list;
}

graph::Buffer addEdgeGroups(graph::Frame& frame, graph::Buffer counters) {
    auto node = frame.compute("gather/groups", shaders::gatherGroups);
    node.read(shared::SLOT_GATHER_COUNTERS, counters);
    const graph::Buffer groups =
        node.write(shared::SLOT_GATHER_GROUPS, frame.buffer("edge groups", {3 * sizeof(uint32_t)}));
    node.dispatch(1);
    return groups;
}

Gathered addGather(graph::Frame& frame, const deferred::Surface& surface,
                   const photons::PhotonList& photons, const TileBins& bins, const EdgeList& edges,
                   const GatherSettings& settings, const Gathered& before) {
    return {addCoarse(frame, surface, photons, bins, settings, before.coarse),
            addEstimates(frame, surface, photons, bins, edges, settings, before.estimates)};
}

}  // namespace lampyris::photon_gi
