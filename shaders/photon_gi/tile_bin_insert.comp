// full: moves the pairs of a share to their tiles' lists, keeping their order: a workgroup's first subgroup, whatever its
// size, goes through the share.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
#include "lib/pair_shares.glsl"
#include "lib/view_space.glsl"

layout(local_size_x = 32) in;
layout(set = 0, binding = SLOT_BIN_PAIRS, std430) readonly buffer Pairs { uvec2 pairs[]; };
layout(set = 0, binding = SLOT_BIN_OFFSETS, std430) readonly buffer Offsets { uint offsets[]; };
layout(set = 0, binding = SLOT_BIN_SHARES, std430) coherent buffer Shares { uint shares[]; };
layout(set = 0, binding = SLOT_BIN_INDICES, std430) writeonly buffer Indices { uint indices[]; };

void main() {
    if (gl_SubgroupID > 0u) return;
    uint lanes = min(gl_SubgroupSize, gl_WorkGroupSize.x);
    uint row = gl_WorkGroupID.x * view.tilesX * view.tilesY;
    uint first = gl_WorkGroupID.x * params.share;
    uint end = min(first + params.share, pairCount());
    uint lane = gl_SubgroupInvocationID;
    for (uint base = first; base < end; base += lanes) {
        bool here = base + lane < end;
        uvec2 pair = pairs[min(base + lane, end - 1u)];
        // Pairs of the same tile at lanes before and after this one.
        uint before = 0u, after = 0u;
        for (uint other = 0u; other < min(lanes, end - base); ++other) {
            bool same = subgroupBroadcast(pair.x, other) == pair.x;
            if (same && other < lane) ++before;
            if (same && other > lane) ++after;
        }
        uint place = shares[row + pair.x] + before;
        subgroupBarrier();  // all have read before the last of each tile writes
        if (here) indices[offsets[pair.x] + place] = pair.y;
        if (here && after == 0u) shares[row + pair.x] = place + 1u;
        subgroupBarrier();
    }
}
