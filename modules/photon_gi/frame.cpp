// Read this file first: the frame as a storyboard. Each node is one function in a file of its own
// name.
#include "photon_gi/frame.h"

#include "deferred/show_surface.h"
#include "deferred/sphere_direct.h"
#include "photon_gi/composite.h"
#include "photon_gi/show_light.h"
#include "photon_gi/tile_gather.h"
#include "photons/path_guide.h"

namespace lampyris::photon_gi {
namespace {

// [chosen] A grid cell's edge for each metre of --radius.
constexpr float kCellsPerRadius = 0.5f;

/// Photons into a grid in the world; a few rays a texel look it up.
JoinedIrradiance addGridGather(graph::Frame& f, const FrameInputs& in, const Settings& s,
                               const Capacities& room, const deferred::Surface& surface,
                               DrawnFrame& out) {
    const photons::TraceSettings trace{s.maxBounces, true, in.seed, room.photons, true};
    const FinalGatherSettings gather{s.gatherDivisor, s.gatherRays, s.filterLevels, in.seed};
    auto cells = photons::beginGrid(
        f, {kCellsPerRadius * s.radiusMetres, room.gridSlots, s.gridColumns, in.seed},
        in.paths.powerScale, clearedCounters(f));
    photons::PhotonList photons;
    for (const auto& batch : photons::batchPaths(in.paths, s.maxBounces, s.largestBatch)) {
        photons = addPhotonTrace(f, in.scene, in.accel, in.paths, batch, trace, cells.counters);
        cells = photons::addToGrid(f, cells, photons, in.scene, in.accel);
        out.ledgers.push_back(photons.ledger);
    }
    const GatherWorld world{in.scene, in.accel, photons::finishGrid(f, cells, in.scene, in.accel)};
    const auto rough = addFinalGather(f, surface, world, gather);
    const auto mean = addFinalHistory(f, surface, rough.coarse, {}, in.past, historyFrames(s), gather);
    const auto smooth = addFinalFilter(f, surface, mean, gather);
    const auto joined = addFinalUpsample(f, surface, world, smooth, cells.counters, gather);
    if (guided(s) && photons.pathCount == in.paths.paths)
        out.importance = addPathImportance(f, photons, cells, world.grid, rough.lookUps);
    return joined;
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

DrawnFrame drawFrame(graph::Frame& f, const FrameInputs& in, const Settings& s,
                     const Capacities& room) {
    DrawnFrame out;
    const auto surface = deferred::addGBuffer(f, in.view, in.scene, in.draws);
    const auto bounds = deferred::addTileBounds(f, surface);
    const auto lights =
        deferred::addLightLists(f, surface, bounds, in.scene, s.lightCutoff, in.seed);
    const auto direct = addDirect(f, in, s, surface, lights);

    JoinedIrradiance indirect;
    if (s.pipeline != Pipeline::Direct && s.maxBounces > 0 && in.paths.paths > 0)
        indirect = finalGathers(s) ? addGridGather(f, in, s, room, surface, out)
                                   : addTileGather(f, in, s, room, surface, bounds, out.ledgers);
    out.counters = indirect.edges.counters;

    out.radiance = addComposite(f, surface, direct, indirect.irradiance, lights, in.scene);
    out.lightReach = lights.reach;
    f.publish("final", out.radiance);
    deferred::publishSurface(f, surface);
    publishLight(f, surface, direct, indirect.irradiance, indirect.edges);
    return out;
}

}  // namespace lampyris::photon_gi
