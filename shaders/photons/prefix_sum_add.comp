// Adds the sum before its block to every offset; the grand total becomes the last offset.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/saturating.glsl"
#include "shared/photon.h"

layout(local_size_x = 64) in;  // SCAN_THREADS
layout(push_constant) uniform Push { uint count; };
layout(set = 0, binding = SLOT_SCAN_OFFSETS, std430) buffer Offsets { uint offsets[]; };
layout(set = 0, binding = SLOT_SCAN_BLOCKS, std430) readonly buffer Blocks { uint blocks[]; };

void main() {
    uint block = gl_WorkGroupID.x;
    uint before = blocks[block];
    for (uint i = gl_LocalInvocationIndex; i < SCAN_BLOCK; i += SCAN_THREADS) {
        uint at = block * SCAN_BLOCK + i;
        if (at < count) offsets[at] = saturatingAdd(offsets[at], before);
        if (at == count) offsets[at] = blocks[gl_NumWorkGroups.x];
    }
    if ((block + 1u) * SCAN_BLOCK == count && block + 1u == gl_NumWorkGroups.x && gl_LocalInvocationIndex == 0u)
        offsets[count] = blocks[gl_NumWorkGroups.x];
}
