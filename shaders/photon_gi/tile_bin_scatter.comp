// full, sort: moves each pair to its place for this digit, keeping the order of equals.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/sort_digits.glsl"

layout(local_size_x = 64) in;  // SORT_THREADS
layout(set = 0, binding = SLOT_BIN_INDICES, std430) readonly buffer Indices { uint indices[]; };
layout(set = 0, binding = SLOT_BIN_OFFSETS, std430) readonly buffer Offsets { uint offsets[]; };
layout(set = 0, binding = SLOT_BIN_SORTED_TILES, std430) writeonly buffer SortedTiles { uint sortedTiles[]; };
layout(set = 0, binding = SLOT_BIN_SORTED_INDICES, std430) writeonly buffer SortedIndices { uint sortedIndices[]; };

void main() {
    uint thread = gl_LocalInvocationIndex;
    uint total = pairCount();
    if (gl_WorkGroupID.x * SORT_BLOCK >= total) return;
    uint first = min(gl_WorkGroupID.x * SORT_BLOCK + thread * kPairsPerThread, total);
    uint last = min(first + kPairsPerThread, total);
    countDigits(thread, first, last);
    if (thread < SORT_DIGITS) {
        uint running = offsets[thread * params.blocks + gl_WorkGroupID.x];
        for (uint t = 0u; t < SORT_THREADS; ++t) {
            uint own = digitCounts[thread * SORT_THREADS + t];
            digitCounts[thread * SORT_THREADS + t] = running;
            running += own;
        }
    }
    barrier();
    for (uint i = first; i < last; ++i) {
        uint tile = tiles[i];
        uint slot = digitOf(tile) * SORT_THREADS + thread;
        uint to = digitCounts[slot]++;
        sortedTiles[to] = tile;
        sortedIndices[to] = indices[i];
    }
}
