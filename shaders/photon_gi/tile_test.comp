// thesis: every tile tests every photon, 64 threads a tile [Thesis listing 5.12]; run once to count, once to insert
// (TILE_INSERT). Eight threads share one contiguous eighth of the photons, so that lists come out in photon order
// whatever the size of a subgroup.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_shuffle : require
#include "lib/bin_bounds.glsl"
#include "lib/bin_photons.glsl"

layout(local_size_x = 64) in;
#ifdef TILE_INSERT
layout(set = 0, binding = SLOT_BIN_OFFSETS, std430) readonly buffer Offsets { uint offsets[]; };
layout(set = 0, binding = SLOT_BIN_INDICES, std430) writeonly buffer Indices { uint indices[]; };
layout(set = 0, binding = SLOT_BIN_RANGES, std430) writeonly buffer Ranges { uvec2 ranges[]; };
layout(set = 0, binding = SLOT_BIN_COUNTERS, std430) buffer Counters { FrameCounters counters; };
#else
layout(set = 0, binding = SLOT_BIN_COUNTS, std430) writeonly buffer Counts { uint counts[]; };
#endif

const uint kLanes = 64u / TILE_CHUNKS;

// The ballot of this thread's own eight.
uint chunkBallot(bool value) {
    uvec4 ballot = subgroupBallot(value);
    uint lane = gl_SubgroupInvocationID & ~(kLanes - 1u);
    return (ballot[lane / 32u] >> (lane % 32u)) & ((1u << kLanes) - 1u);
}

#ifdef TILE_INSERT
void publishTile(uint tile) {
    uint first = offsets[tile * TILE_CHUNKS];
    uint end = offsets[(tile + 1u) * TILE_CHUNKS];
    uint kept = min(end, params.pairCapacity) - min(first, params.pairCapacity);
    ranges[tile] = uvec2(first, kept);
    atomicMax(counters.mostInTile, kept);
    if (tile == 0u) {
        uint total = offsets[view.tilesX * view.tilesY * TILE_CHUNKS];
        atomicAdd(counters.pairs, min(total, params.pairCapacity));
        atomicAdd(counters.pairsDropped, total - min(total, params.pairCapacity));
        atomicMax(counters.pairsNeeded, total);
    }
}
#endif

void main() {
    uint tile = gl_WorkGroupID.y * view.tilesX + gl_WorkGroupID.x;
    uint chunk = gl_LocalInvocationIndex / kLanes;
    uint lane = gl_LocalInvocationIndex % kLanes;
    vec2 depths = boundsOf(gl_WorkGroupID.xy);
    TileFrustum frustum = tileFrustum(gl_WorkGroupID.xy, depths);
    uint total = depths.x <= depths.y ? photonCount() : 0u;
    uint share = (total + TILE_CHUNKS - 1u) / TILE_CHUNKS;
    uint end = min((chunk + 1u) * share, total);
    uint rounds = (share + kLanes - 1u) / kLanes;
#ifdef TILE_INSERT
    uint at = offsets[tile * TILE_CHUNKS + chunk];
    if (gl_LocalInvocationIndex == 0u) publishTile(tile);
#else
    uint count = 0u;
#endif
    // The same number of rounds for all, so that every ballot is whole.
    for (uint r = 0u; r < rounds; ++r) {
        uint photon = chunk * share + r * kLanes + lane;
        bool inside = photon < end && sphereTouchesTile(photonViewDepth(min(photon, total - 1u)), params.radius, frustum);
#ifdef TILE_INSERT
        uint ballot = chunkBallot(inside);
        uint to = at + bitCount(ballot & ((1u << lane) - 1u));
        if (inside && to < params.pairCapacity) indices[to] = photon;
        at += bitCount(ballot);
#else
        count += inside ? 1u : 0u;
#endif
    }
#ifndef TILE_INSERT
    for (uint offset = kLanes / 2u; offset > 0u; offset /= 2u) count += subgroupShuffleXor(count, offset);
    if (lane == 0u) counts[tile * TILE_CHUNKS + chunk] = count;
#endif
}
