#include "photon_gi/tile_gather.h"

#include "photon_gi/tile_test.h"
#include "photon_gi/upsample.h"

namespace lampyris::photon_gi {

JoinedIrradiance addTileGather(graph::Frame& f, const FrameInputs& in, const Settings& s,
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
        out.insides.photons = photons;
        out.insides.tileRanges = tiles.ranges;
    }
    return {addUpsample(f, surface, gathered, edges, gather), edges};
}

}  // namespace lampyris::photon_gi
