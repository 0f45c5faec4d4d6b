// Read this file first: the frame as a storyboard. Each node is one function in a file of its own
// name.
#include "photon_gi/frame.h"

#include "deferred/show_surface.h"
#include "deferred/sphere_direct.h"
#include "photon_gi/composite.h"
#include "photon_gi/final_gather.h"
#include "photon_gi/show_light.h"
#include "photon_gi/tile_test.h"
#include "photon_gi/upsample.h"

namespace lampyris::photon_gi {
namespace {

// [chosen] A grid cell's edge for each metre of --radius.
constexpr float kCellsPerRadius = 0.5f;

struct Indirect {
    graph::Image irradiance;
    EdgeList edges;
};

graph::Buffer clearedCounters(graph::Frame& f) {
    auto clear = f.transfer("gather/clear");
    return clear.fill(f.buffer("frame counters", {sizeof(shared::FrameCounters)}), 0);
}

/// Photons of one batch after the other: traced, binned, gathered; their irradiances add up.
Indirect addTileGather(graph::Frame& f, const FrameInputs& in, const Settings& s,
                       const Capacities& room, const deferred::Surface& surface,
                       const deferred::TileBounds& bounds, DrawnFrame& out) {
    const bool thesis = s.pipeline == Pipeline::Thesis;
    const GatherSettings gather{s.radiusMetres, s.gatherDivisor};
    const photons::TraceSettings trace{s.maxBounces, !thesis, in.seed, room.photons};
    auto edges = addEdges(f, surface, clearedCounters(f), gather);
    Gathered gathered;
    for (const auto& batch : photons::batchPaths(in.paths, s.maxBounces, s.largestBatch)) {
        const auto photons =
            photons::addPhotonTrace(f, in.scene, in.accel, in.paths, batch, trace, edges.counters);
        const auto tiles =
            thesis ? addTileTest(f, photons, bounds, in.view, {s.radiusMetres, room.pairs})
                   : addTileBin(f, photons, bounds, in.view, {s.radiusMetres, room.pairs});
        edges.counters = tiles.counters;
        gathered = addGather(f, surface, photons, tiles, edges, gather, gathered);
        out.ledgers.push_back(photons.ledger);
    }
    out.counters = edges.counters;
    return {addUpsample(f, surface, gathered, edges, gather), edges};
}

CoarseIrradiance addHistory(graph::Frame& f, const FrameInputs& in, const Settings& s,
                            const deferred::Surface& surface, const CoarseIrradiance& newest,
                            const FinalGatherSettings& gather) {
    if (s.history == 0) return newest;
    GatherPast past;
    auto guide = historyMean(in.view, s);
    guide.format = graph::Format::RGBA32Uint;
    past.mean = f.history(kHistoryMean, historyMean(in.view, s), in.past.known);
    past.guide = f.history("gather guide history", guide, in.past.known);
    past.worldToClipBefore = in.past.worldToClip;
    past.frames = in.past.known && in.past.same && s.reseed ? s.history - 1 : 0;
    return addFinalHistory(f, surface, newest, past, gather);
}

/// Photons into a grid in the world; a few rays a texel look it up.
Indirect addGridGather(graph::Frame& f, const FrameInputs& in, const Settings& s,
                       const Capacities& room, const deferred::Surface& surface, DrawnFrame& out) {
    const photons::TraceSettings trace{s.maxBounces, true, in.seed, room.photons, true};
    const photons::GridSettings grid{kCellsPerRadius * s.radiusMetres, room.gridSlots,
                                     s.gridColumns, in.seed};
    auto cells = photons::beginGrid(f, grid, in.paths.powerScale);
    cells.counters = clearedCounters(f);
    for (const auto& batch : photons::batchPaths(in.paths, s.maxBounces, s.largestBatch)) {
        const auto photons =
            photons::addPhotonTrace(f, in.scene, in.accel, in.paths, batch, trace, cells.counters);
        cells = photons::addToGrid(f, cells, photons, in.scene, in.accel);
        out.ledgers.push_back(photons.ledger);
    }
    const GatherWorld world{in.scene, in.accel, photons::finishGrid(f, cells, in.scene, in.accel)};
    const FinalGatherSettings gather{s.gatherDivisor, s.gatherRays, s.filterLevels, in.seed};
    const auto rough = addFinalGather(f, surface, world, gather);
    const auto mean = addHistory(f, in, s, surface, rough, gather);
    const auto smooth = addFinalFilter(f, surface, mean, gather);
    const auto joined = addFinalUpsample(f, surface, world, smooth, cells.counters, gather);
    out.counters = joined.edges.counters;
    return {joined.irradiance, joined.edges};
}

deferred::DirectLight addDirect(graph::Frame& f, const FrameInputs& in, const Settings& s,
                                const deferred::Surface& surface,
                                const deferred::LightLists& lights) {
    if (!s.shadows || s.pipeline == Pipeline::Thesis)
        return deferred::addUnshadowedDirect(f, surface, lights, in.scene);
    const deferred::ShadowSettings shadow{s.shadowDivisor, s.shadowRays, in.seed};
    const auto shadows = deferred::addShadow(f, surface, lights, in.scene, in.accel, shadow);
    return deferred::addSphereDirect(f, surface, lights, shadows, in.scene, in.accel);
}

}  // namespace

graph::ImageDesc historyMean(const shared::View& view, const Settings& settings) {
    return {graph::Format::RGBA32Float, coarseSize(view, settings.gatherDivisor)};
}

DrawnFrame drawFrame(graph::Frame& f, const FrameInputs& in, const Settings& s,
                     const Capacities& room) {
    DrawnFrame out;
    const auto surface = deferred::addGBuffer(f, in.view, in.scene, in.draws);
    const auto bounds = deferred::addTileBounds(f, surface);
    const auto lights =
        deferred::addLightLists(f, surface, bounds, in.scene, s.lightCutoff, in.seed);
    const auto direct = addDirect(f, in, s, surface, lights);

    Indirect indirect;
    if (s.pipeline != Pipeline::Direct && s.maxBounces > 0 && in.paths.paths > 0)
        indirect = s.pipeline == Pipeline::Full && s.gather == Gather::Final
                       ? addGridGather(f, in, s, room, surface, out)
                       : addTileGather(f, in, s, room, surface, bounds, out);

    out.radiance = addComposite(f, surface, direct, indirect.irradiance, lights, in.scene);
    out.lightReach = lights.reach;
    f.publish("final", out.radiance);
    deferred::publishSurface(f, surface);
    publishLight(f, surface, direct, indirect.irradiance, indirect.edges);
    return out;
}

}  // namespace lampyris::photon_gi
