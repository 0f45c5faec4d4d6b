#include "photon_gi/grid_gather.h"

#include "deferred/motion.h"
#include "photons/path_guide.h"

namespace lampyris::photon_gi {
namespace {

// [chosen] A grid cell's edge for each metre of --radius.
constexpr float kCellsPerRadius = 1.0f;

}  // namespace

JoinedIrradiance addGridGather(graph::Frame& f, const FrameInputs& in, const Settings& s,
                               const Capacities& room, const deferred::Surface& surface,
                               DrawnFrame& out) {
    const photons::TraceSettings trace{s.maxBounces, true, frameSeed(s, 0),
                                       room.photons, true, in.pathTurn};
    const FinalGatherSettings gather{s.gatherDivisor, s.gatherRays, s.filterLevels, s.seed,
                                     in.turn};
    auto cells = photons::beginGrid(
        f,
        {kCellsPerRadius * s.radiusMetres, room.gridSlots, s.gridColumns, frameSeed(s, 0), in.turn},
        in.paths.powerScale, clearedCounters(f));
    photons::PhotonList photons;
    const auto take = [&](const photons::PhotonList& batch) {
        photons = batch;
        cells = photons::addToGrid(f, cells, photons, in.scene, in.accel);
        out.ledgers.push_back(photons.ledger);
    };
    if (in.pathsKept) {
        take(photons::addPhotonTraceKept(f, in.scene, in.accel, in.paths, in.store, in.choice,
                                         trace, cells.counters));
    } else {
        for (const auto& batch : photons::batchPaths(in.paths, s.maxBounces, s.largestBatch))
            take(addPhotonTrace(f, in.scene, in.accel, in.paths, batch, trace, cells.counters));
    }
    const GatherWorld world{in.scene, in.accel, photons::finishGrid(f, cells, in.scene, in.accel)};
    const auto rough = addFinalGather(f, surface, world, gather);
    const graph::Image motion =
        historyFrames(s) > 1 ? deferred::addMotion(f, surface, in.scene, in.draws) : graph::Image{};
    const auto mean =
        addFinalHistory(f, surface, rough.coarse, motion, in.past, historyFrames(s), gather);
    out.insides.photons = photons;
    out.insides.mean = mean.mean;
    out.insides.meanDivisor = s.gatherDivisor;
    const auto smooth = addFinalFilter(f, surface, mean, gather);
    const auto joined = addFinalUpsample(f, surface, world, smooth, cells.counters, gather);
    if (guided(s) && photons.pathCount == in.paths.paths)
        out.importance = addPathImportance(f, photons, cells, world.grid, rough.lookUps);
    return joined;
}

}  // namespace lampyris::photon_gi
