#include "photon_gi/tile_test.h"

#include "deferred/view.h"
#include "photon_gi/shaders.h"
#include "photons/prefix_sum.h"
#include "shared/tile_bin.h"

namespace lampyris::photon_gi {

TileBins addTileTest(graph::Frame& frame, const photons::PhotonList& photons,
                     const deferred::TileBounds& bounds, const shared::View& view,
                     const TileSettings& settings) {
    const uint32_t tiles = deferred::tileCount(view);
    const uint32_t countSize = tiles * shared::TILE_CHUNKS;
    shared::BinParams params{};
    params.capacity = photons.capacity;
    params.pathCount = photons.pathCount;
    params.pairCapacity = settings.pairCapacity;
    params.radius = settings.radiusMetres;
    const auto bindTest = [&](graph::ComputeNode& node) {
        node.texels(shared::SLOT_BIN_PHOTONS, photons.photons, graph::Format::RGBA32Uint)
            .read(shared::SLOT_BIN_PHOTON_TOTAL, photons.pathOffsets)
            .texels(shared::SLOT_BIN_BOUNDS, bounds.bounds, graph::Format::RG32Float)
            .uniformData(shared::SLOT_VIEW, view)
            .push(params);
    };

    auto count = frame.compute("tile_bin/count", shaders::tileTest);
    bindTest(count);
    const graph::Buffer counts =
        count.write(shared::SLOT_BIN_COUNTS,
                    frame.buffer("photons a tile", {uint64_t{countSize} * sizeof(uint32_t)}));
    count.dispatch(view.tilesX, view.tilesY);

    const graph::Buffer offsets = photons::addPrefixSum(frame, "tile_bin", counts, countSize);
    auto insert = frame.compute("tile_bin/insert", shaders::tileTestInsert);
    bindTest(insert);
    insert.read(shared::SLOT_BIN_OFFSETS, offsets);
    TileBins bins;
    bins.indices = insert.write(
        shared::SLOT_BIN_INDICES,
        frame.buffer("tile photons", {uint64_t{settings.pairCapacity} * sizeof(uint32_t)}));
    bins.ranges =
        insert.write(shared::SLOT_BIN_RANGES, frame.buffer("tile ranges", {uint64_t{tiles} * 8}));
    bins.counters = insert.update(shared::SLOT_BIN_COUNTERS, photons.counters);
    insert.dispatch(view.tilesX, view.tilesY);
    return bins;
}

}  // namespace lampyris::photon_gi
