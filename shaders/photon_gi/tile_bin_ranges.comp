// full: where each tile's photons stand among the sorted pairs, by binary search.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/view_space.glsl"
#include "shared/photon.h"
#include "shared/tile_bin.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { BinParams params; };
layout(set = 0, binding = SLOT_BIN_SORTED_TILES, std430) readonly buffer SortedTiles { uint sortedTiles[]; };
layout(set = 0, binding = SLOT_BIN_PHOTON_TOTAL, std430) readonly buffer PairTotal { uint pairOffsets[]; };
layout(set = 0, binding = SLOT_BIN_RANGES, std430) writeonly buffer Ranges { uvec2 ranges[]; };
layout(set = 0, binding = SLOT_BIN_COUNTERS, std430) buffer Counters { FrameCounters counters; };

uint firstNotBelow(uint tile, uint total) {
    uint low = 0u, high = total;
    while (low < high) {
        uint middle = (low + high) / 2u;
        if (sortedTiles[middle] < tile) low = middle + 1u;
        else high = middle;
    }
    return low;
}

void main() {
    uint tile = gl_GlobalInvocationID.x;
    if (tile >= view.tilesX * view.tilesY) return;
    uint total = min(pairOffsets[params.capacity], params.pairCapacity);
    uint first = firstNotBelow(tile, total);
    uint count = firstNotBelow(tile + 1u, total) - first;
    ranges[tile] = uvec2(first, count);
    atomicMax(counters.mostInTile, count);
}
