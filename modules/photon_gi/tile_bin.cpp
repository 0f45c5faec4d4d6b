#include "photon_gi/tile_bin.h"

#include <bit>

#include "deferred/view.h"
#include "photon_gi/shaders.h"
#include "photons/prefix_sum.h"
#include "shared/tile_bin.h"

namespace lampyris::photon_gi {
namespace {

/// Pairs in the order of some digits of their tile.
struct Pairs {
    graph::Buffer tiles{};
    graph::Buffer indices{};
    graph::Buffer offsets{};  ///< before each photon; [capacity] is the number of pairs
};

void bindPhotons(graph::ComputeNode& node, const photons::PhotonList& photons,
                 const deferred::TileBounds& bounds, const shared::View& view,
                 const shared::BinParams& params) {
    node.texels(shared::SLOT_BIN_PHOTONS, photons.photons, graph::Format::RGBA32Uint)
        .read(shared::SLOT_BIN_PHOTON_TOTAL, photons.pathOffsets)
        .read(shared::SLOT_BIN_BOUNDS, bounds.bounds)
        .uniformData(shared::SLOT_VIEW, view)
        .push(params);
}

Pairs addPairs(graph::Frame& frame, const photons::PhotonList& photons,
               const deferred::TileBounds& bounds, const shared::View& view,
               const shared::BinParams& params, graph::Buffer& counters) {
    const uint32_t groups = (params.capacity + 63) / 64;
    auto count = frame.compute("tile_bin/count", shaders::tileBinCount);
    bindPhotons(count, photons, bounds, view, params);
    const graph::Buffer counts =
        count.write(shared::SLOT_BIN_COUNTS,
                    frame.buffer("tiles a photon", {uint64_t{params.capacity} * sizeof(uint32_t)}));
    count.dispatch(groups);

    Pairs pairs;
    pairs.offsets = photons::addPrefixSum(frame, "tile_bin", counts, params.capacity);
    auto write = frame.compute("tile_bin/pairs", shaders::tileBinPairs);
    bindPhotons(write, photons, bounds, view, params);
    write.read(shared::SLOT_BIN_OFFSETS, pairs.offsets);
    const graph::BufferDesc desc{uint64_t{params.pairCapacity} * sizeof(uint32_t)};
    pairs.tiles = write.write(shared::SLOT_BIN_TILES, frame.buffer("pair tiles", desc));
    pairs.indices = write.write(shared::SLOT_BIN_INDICES, frame.buffer("pair photons", desc));
    counters = write.update(shared::SLOT_BIN_COUNTERS, counters);
    write.dispatch(groups);
    return pairs;
}

Pairs addSortDigit(graph::Frame& frame, const Pairs& pairs, const shared::BinParams& params) {
    auto digits = frame.compute("tile_bin/digits", shaders::tileBinDigits);
    digits.read(shared::SLOT_BIN_TILES, pairs.tiles)
        .read(shared::SLOT_BIN_PHOTON_TOTAL, pairs.offsets)
        .push(params);
    const uint32_t countSize = shared::SORT_DIGITS * params.blocks;
    const graph::Buffer counts =
        digits.write(shared::SLOT_BIN_COUNTS,
                     frame.buffer("digit counts", {uint64_t{countSize} * sizeof(uint32_t)}));
    digits.dispatch(params.blocks);

    const graph::Buffer offsets = photons::addPrefixSum(frame, "tile_bin", counts, countSize);
    auto scatter = frame.compute("tile_bin/scatter", shaders::tileBinScatter);
    scatter.read(shared::SLOT_BIN_TILES, pairs.tiles)
        .read(shared::SLOT_BIN_INDICES, pairs.indices)
        .read(shared::SLOT_BIN_OFFSETS, offsets)
        .read(shared::SLOT_BIN_PHOTON_TOTAL, pairs.offsets)
        .push(params);
    const graph::BufferDesc desc{uint64_t{params.pairCapacity} * sizeof(uint32_t)};
    Pairs sorted{.offsets = pairs.offsets};
    sorted.tiles = scatter.write(shared::SLOT_BIN_SORTED_TILES, frame.buffer("sorted tiles", desc));
    sorted.indices =
        scatter.write(shared::SLOT_BIN_SORTED_INDICES, frame.buffer("sorted photons", desc));
    scatter.dispatch(params.blocks);
    return sorted;
}

}  // namespace

TileBins addTileBin(graph::Frame& frame, const photons::PhotonList& photons,
                    const deferred::TileBounds& bounds, const shared::View& view,
                    const TileSettings& settings) {
    const uint32_t tiles = deferred::tileCount(view);
    shared::BinParams params{};
    params.capacity = photons.capacity;
    params.pathCount = photons.pathCount;
    params.pairCapacity = settings.pairCapacity;
    params.radius = settings.radiusMetres;
    params.blocks = (settings.pairCapacity + shared::SORT_BLOCK - 1) / shared::SORT_BLOCK;

    TileBins bins{.counters = photons.counters};
    Pairs pairs = addPairs(frame, photons, bounds, view, params, bins.counters);
    const auto tileBits = static_cast<uint32_t>(std::bit_width(tiles - 1));
    for (params.shift = 0; params.shift < tileBits; params.shift += shared::SORT_DIGIT_BITS)
        pairs = addSortDigit(frame, pairs, params);

    auto ranges = frame.compute("tile_bin/ranges", shaders::tileBinRanges);
    ranges.read(shared::SLOT_BIN_SORTED_TILES, pairs.tiles)
        .read(shared::SLOT_BIN_PHOTON_TOTAL, pairs.offsets)
        .uniformData(shared::SLOT_VIEW, view)
        .push(params);
    bins.indices = pairs.indices;
    bins.ranges =
        ranges.write(shared::SLOT_BIN_RANGES, frame.buffer("tile ranges", {uint64_t{tiles} * 8}));
    bins.counters = ranges.update(shared::SLOT_BIN_COUNTERS, bins.counters);
    ranges.dispatch((tiles + 63) / 64);
    return bins;
}

}  // namespace lampyris::photon_gi
