#include "photon_gi/tile_bin.h"

#include <algorithm>
#include <bit>

#include "deferred/view.h"
#include "photon_gi/shaders.h"
#include "photons/prefix_sum.h"
#include "shared/tile_bin.h"

namespace lampyris::photon_gi {
namespace {

/// Pairs a share: enough shares to keep a device busy, few enough that their counters, one a tile
/// each, cost less than the pairs.
constexpr uint32_t kShares = 16;
constexpr uint32_t kLeastShare = 1u << 10;
constexpr uint32_t kMostShare = 1u << 15;
/// lavapipe ends a shader's loops, unasked and silently, after 65535 turns in all [measured]. A
/// thread's two loops over a box of tiles stay below that.
constexpr uint32_t kMostTurns = 65500;
constexpr uint32_t kMostWords = 1u << 25;  ///< 128 MiB

uint32_t rowsABand(const shared::View& view) {
    return std::clamp((kMostTurns / 2 - 1) / (view.tilesX + 2), 1u, view.tilesY);
}

shared::BinParams binParams(const photons::PhotonList& photons, const shared::View& view,
                            const TileSettings& settings) {
    shared::BinParams params{};
    params.capacity = photons.capacity;
    params.pathCount = photons.pathCount;
    params.pairCapacity = settings.pairCapacity;
    params.radius = settings.radiusMetres;
    params.share =
        std::clamp(std::bit_ceil(settings.pairCapacity / kShares), kLeastShare, kMostShare);
    params.bandRows = rowsABand(view);
    params.bands = (view.tilesY + params.bandRows - 1) / params.bandRows;
    return params;
}

/// What the nodes of one binning share.
struct Binning {
    const photons::PhotonList& photons;
    const deferred::TileBounds& bounds;
    const shared::View& view;
    const shared::BinParams params;
    const uint32_t tiles = deferred::tileCount(view);
    const uint32_t shares = (params.pairCapacity + params.share - 1) / params.share;
};

graph::Buffer words(graph::Frame& frame, const char* name, uint64_t count) {
    return frame.buffer(name, {count * sizeof(uint32_t)});
}

/// Binds and dispatches what counting and writing the pairs have in common.
void visitTiles(graph::ComputeNode& node, const Binning& b) {
    node.texels(shared::SLOT_BIN_PHOTONS, b.photons.photons, graph::Format::RGBA32Uint)
        .texels(shared::SLOT_BIN_BOUNDS, b.bounds.bounds, graph::Format::RG32Float)
        .read(shared::SLOT_BIN_PHOTON_TOTAL, b.photons.pathOffsets)
        .uniformData(shared::SLOT_VIEW, b.view)
        .push(b.params)
        .dispatch((b.params.capacity + 63) / 64, b.params.bands);
}

/// Sums before each photon's and band's pairs; the last is the number of all.
graph::Buffer addPairOffsets(graph::Frame& frame, const Binning& b) {
    auto node = frame.compute("tile_bin/count", shaders::tileBinCount);
    const uint32_t places = b.params.capacity * b.params.bands;
    const graph::Buffer counts =
        node.write(shared::SLOT_BIN_COUNTS, words(frame, "pairs a photon", places));
    visitTiles(node, b);
    return photons::addPrefixSum(frame, "tile_bin", counts, places);
}

struct Pairs {
    graph::Buffer offsets{};  ///< before each photon
    graph::Buffer pairs{};    ///< uvec2: tile, photon; photon by photon
    graph::Buffer shares{};   ///< [share][tile]: pairs
};

Pairs addPairs(graph::Frame& frame, const Binning& b) {
    Pairs pairs{.offsets = addPairOffsets(frame, b)};
    auto clear = frame.transfer("tile_bin/clear");
    pairs.shares =
        clear.fill(words(frame, "pairs a share and tile", uint64_t{b.shares} * b.tiles), 0);
    auto node = frame.compute("tile_bin/pairs", shaders::tileBinPairs);
    node.read(shared::SLOT_BIN_OFFSETS, pairs.offsets);
    pairs.pairs = node.write(shared::SLOT_BIN_PAIRS,
                             words(frame, "pairs", 2 * uint64_t{b.params.pairCapacity}));
    pairs.shares = node.update(shared::SLOT_BIN_SHARES, pairs.shares);
    visitTiles(node, b);
    return pairs;
}

/// Binds and dispatches a node with a thread a tile.
void visitSums(graph::ComputeNode& node, const Binning& b, const Pairs& pairs) {
    node.read(shared::SLOT_BIN_PAIR_TOTAL, pairs.offsets)
        .uniformData(shared::SLOT_VIEW, b.view)
        .push(b.params)
        .dispatch((b.tiles + 63) / 64);
}

/// Sums before each tile, and within a tile before each share.
graph::Buffer addTileOffsets(graph::Frame& frame, const Binning& b, Pairs& pairs) {
    auto node = frame.compute("tile_bin/shares", shaders::tileBinShares);
    pairs.shares = node.update(shared::SLOT_BIN_SHARES, pairs.shares);
    const graph::Buffer counts =
        node.write(shared::SLOT_BIN_COUNTS, words(frame, "pairs a tile", b.tiles));
    visitSums(node, b, pairs);
    return photons::addPrefixSum(frame, "tile_bin", counts, b.tiles);
}

void addRanges(graph::Frame& frame, const Binning& b, const Pairs& pairs, graph::Buffer offsets,
               TileBins& bins) {
    auto node = frame.compute("tile_bin/ranges", shaders::tileBinRanges);
    node.read(shared::SLOT_BIN_OFFSETS, offsets);
    bins.ranges =
        node.write(shared::SLOT_BIN_RANGES, words(frame, "tile ranges", 2 * uint64_t{b.tiles}));
    bins.counters = node.update(shared::SLOT_BIN_COUNTERS, bins.counters);
    visitSums(node, b, pairs);
}

graph::Buffer addInsert(graph::Frame& frame, const Binning& b, const Pairs& pairs,
                        graph::Buffer offsets) {
    auto node = frame.compute("tile_bin/insert", shaders::tileBinInsert);
    node.read(shared::SLOT_BIN_PAIRS, pairs.pairs)
        .read(shared::SLOT_BIN_PAIR_TOTAL, pairs.offsets)
        .read(shared::SLOT_BIN_OFFSETS, offsets)
        .uniformData(shared::SLOT_VIEW, b.view)
        .push(b.params);
    (void)node.update(shared::SLOT_BIN_SHARES, pairs.shares);
    const graph::Buffer indices =
        node.write(shared::SLOT_BIN_INDICES, words(frame, "tile photons", b.params.pairCapacity));
    node.dispatch(b.shares);
    return indices;
}

}  // namespace

uint32_t mostPairsBinned(graph::Extent size) {
    const graph::Extent tiles = size.dividedBy(shared::TILE_PIXELS);
    const uint64_t tileCount = uint64_t{tiles.width} * tiles.height;
    const uint64_t shares = std::max<uint64_t>(kMostWords / tileCount, 1);
    return static_cast<uint32_t>(std::min<uint64_t>(shares * kMostShare, kMostWords / 2));
}

TileBins addTileBin(graph::Frame& frame, const photons::PhotonList& photons,
                    const deferred::TileBounds& bounds, const shared::View& view,
                    const TileSettings& settings) {
    const Binning b{photons, bounds, view, binParams(photons, view, settings)};
    TileBins bins{.counters = photons.counters};
    Pairs pairs = addPairs(frame, b);
    const graph::Buffer offsets = addTileOffsets(frame, b, pairs);
    addRanges(frame, b, pairs, offsets, bins);
    bins.indices = addInsert(frame, b, pairs, offsets);
    return bins;
}

}  // namespace lampyris::photon_gi
