#include "photon_gi/final_gather.h"

#include "core/check.h"
#include "photon_gi/shaders.h"
#include "photon_gi/upsample.h"
#include "shared/tile_bin.h"

namespace lampyris::photon_gi {

shared::GatherParams finalParams(const shared::View& view, const FinalGatherSettings& settings,
                                 uint32_t step) {
    const graph::Extent coarse = coarseSize(view, settings.divisor);
    shared::GatherParams params{};
    params.divisor = settings.divisor;
    params.coarseWidth = coarse.width;
    params.coarseHeight = coarse.height;
    params.rays = settings.rays;
    params.seed = settings.seed;
    params.turn = settings.turn;
    params.step = step;
    return params;
}

void bindCoarse(graph::ComputeNode& node, const CoarseIrradiance& coarse) {
    node.sample(shared::SLOT_FINAL_COARSE_IN, coarse.irradiance)
        .sample(shared::SLOT_FINAL_GUIDE_IN, coarse.guide);
}

namespace {

/// Of nodes that trace rays.
shared::GatherParams rayParams(const shared::View& view, const GatherWorld& world,
                               const FinalGatherSettings& settings) {
    shared::GatherParams params = finalParams(view, settings);
    params.emitterCount = world.scene.emitterCount;
    return params;
}

void bindWorld(graph::ComputeNode& node, const GatherWorld& world) {
    photons::bindGrid(node, world.grid, world.scene, world.accel);
    residency::bindEmitters(node, world.scene);
}

graph::Image addEdgePixels(graph::Frame& frame, const deferred::Surface& surface,
                           const GatherWorld& world, const CoarseIrradiance& coarse,
                           const EdgeList& edges, graph::Image irradiance,
                           const FinalGatherSettings& settings) {
    auto node = frame.compute("upsample/edges", shaders::finalEdges);
    deferred::bindSurface(node, surface);
    bindWorld(node, world);
    bindCoarse(node, coarse);
    node.read(shared::SLOT_GATHER_COUNTERS, edges.counters)
        .read(shared::SLOT_GATHER_LIST, edges.list)
        .push(rayParams(surface.view, world, settings));
    irradiance = node.update(shared::SLOT_GATHER_IRRADIANCE, irradiance);
    node.dispatchIndirect(edges.groups);
    return irradiance;
}

graph::Image addShareAlone(graph::Frame& frame, const deferred::Surface& surface,
                           const EdgeList& edges, graph::Image irradiance,
                           const FinalGatherSettings& settings) {
    const uint64_t pixels = uint64_t{surface.view.width} * surface.view.height;
    auto node = frame.compute("upsample/alone", shaders::finalAlone);
    deferred::bindSurface(node, surface);
    node.sample(shared::SLOT_FINAL_JOINED, irradiance)
        .read(shared::SLOT_GATHER_COUNTERS, edges.counters)
        .read(shared::SLOT_GATHER_LIST, edges.list)
        .push(finalParams(surface.view, settings));
    const graph::Buffer estimates =
        node.write(shared::SLOT_GATHER_ESTIMATES,
                   frame.buffer("edge estimates", {pixels * sizeof(shared::uvec2)}));
    node.dispatchIndirect(edges.groups);
    return addPlaceEstimates(frame, edges, estimates, EstimateFormat::Halves, irradiance);
}

}  // namespace

FinalGathered addFinalGather(graph::Frame& frame, const deferred::Surface& surface,
                             const GatherWorld& world, const FinalGatherSettings& settings) {
    CHECK(settings.rays > 0u);
    const graph::Extent size = coarseSize(surface.view, settings.divisor);
    auto node = frame.compute("gather", shaders::finalGather);
    deferred::bindSurface(node, surface);
    bindWorld(node, world);
    node.push(rayParams(surface.view, world, settings));
    FinalGathered gathered;
    gathered.coarse.irradiance =
        node.write(shared::SLOT_FINAL_COARSE,
                   frame.image("coarse irradiance", {graph::Format::RGBA32Uint, size}));
    gathered.coarse.guide = node.write(
        shared::SLOT_FINAL_GUIDE, frame.image("gather guide", {graph::Format::RGBA32Uint, size}));
    gathered.lookUps = node.update(shared::SLOT_FINAL_LOOK_UPS, world.grid.lookUps);
    node.dispatchOver(size);
    return gathered;
}

CoarseIrradiance addFinalFilter(graph::Frame& frame, const deferred::Surface& surface,
                                CoarseIrradiance coarse, const FinalGatherSettings& settings) {
    const graph::Extent size = coarseSize(surface.view, settings.divisor);
    for (uint32_t level = 0; level < settings.filterLevels; ++level) {
        auto node = frame.compute("gather/filter", shaders::finalFilter);
        bindCoarse(node, coarse);
        node.uniformData(shared::SLOT_VIEW, surface.view)
            .push(finalParams(surface.view, settings, 1u << level));
        coarse.irradiance =
            node.write(shared::SLOT_FINAL_COARSE,
                       frame.image("filtered irradiance", {graph::Format::RGBA32Uint, size}));
        node.dispatchOver(size);
    }
    return coarse;
}

JoinedIrradiance addFinalUpsample(graph::Frame& frame, const deferred::Surface& surface,
                                  const GatherWorld& world, const CoarseIrradiance& coarse,
                                  graph::Buffer counters, const FinalGatherSettings& settings) {
    const graph::Extent size{surface.view.width, surface.view.height};
    const uint64_t pixels = uint64_t{size.width} * size.height;
    auto node = frame.compute("upsample", shaders::finalUpsample);
    deferred::bindSurface(node, surface);
    bindCoarse(node, coarse);
    node.push(finalParams(surface.view, settings));
    JoinedIrradiance joined;
    joined.irradiance =
        node.write(shared::SLOT_GATHER_IRRADIANCE,
                   frame.image("indirect irradiance", {graph::Format::RGBA16Float, size}));
    joined.edges.list = node.write(shared::SLOT_GATHER_LIST,
                                   frame.buffer("edge list", {pixels * sizeof(uint32_t)}));
    joined.edges.counters = node.update(shared::SLOT_GATHER_COUNTERS, counters);
    node.dispatchOver(coarseBlocks(surface.view, settings.divisor));
    joined.edges.groups = addEdgeGroups(frame, joined.edges.counters);
    joined.irradiance =
        addEdgePixels(frame, surface, world, coarse, joined.edges, joined.irradiance, settings);
    joined.irradiance = addShareAlone(frame, surface, joined.edges, joined.irradiance, settings);
    return joined;
}

}  // namespace lampyris::photon_gi
