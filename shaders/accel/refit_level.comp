#version 460
#extension GL_GOOGLE_include_directive : require
// The boxes of inner nodes of one height, each in its parent, from those of their own children. Whole cells of one
// grid: nothing is rounded.
#include "lib/refit.glsl"
#include "lib/refit_stores.glsl"

layout(local_size_x = 64) in;  // REFIT_THREADS
layout(set = 0, binding = SLOT_REFIT_SLOTS) uniform usamplerBuffer slots;

void main() {
    uint job = refitJob();
    uint index = refitIndex(job);
    if (index >= jobs[job].count) return;
    uint texel = jobs[job].firstTexel + texelFetch(slots, int(jobs[job].firstSlot + index)).x;
    uint node = texelFetch(nodes, int(texel)).w;
    int child = int(node * BVH_NODE_TEXELS);
    uvec3 box = unitedCells(texelFetch(nodes, child).xyz, texelFetch(nodes, child + 1).xyz);
    putNode(texel, uvec4(box, node));
}
