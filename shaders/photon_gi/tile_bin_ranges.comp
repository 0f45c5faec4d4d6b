// full: where each tile's photons stand in the list, and what did not fit.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/pair_shares.glsl"
#include "lib/view_space.glsl"
#include "shared/photon.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = SLOT_BIN_OFFSETS, std430) readonly buffer Offsets { uint offsets[]; };
layout(set = 0, binding = SLOT_BIN_RANGES, std430) writeonly buffer Ranges { uvec2 ranges[]; };
layout(set = 0, binding = SLOT_BIN_COUNTERS, std430) buffer Counters { FrameCounters counters; };

void main() {
    uint tile = gl_GlobalInvocationID.x;
    uint tileCount = view.tilesX * view.tilesY;
    if (tile >= tileCount) return;
    uint count = offsets[tile + 1u] - offsets[tile];
    ranges[tile] = uvec2(offsets[tile], count);
    atomicMax(counters.mostInTile, count);
    if (tile == 0u) {
        atomicAdd(counters.pairs, pairCount());
        atomicAdd(counters.pairsDropped, pairsWanted() - pairCount());
        atomicMax(counters.pairsNeeded, pairsWanted());
    }
}
