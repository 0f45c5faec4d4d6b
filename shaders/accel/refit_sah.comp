#version 460
#extension GL_GOOGLE_include_directive : require
// Parts of the surface area heuristic's cost of each tree, in a fixed order; the CPU adds them up. As accel::costOf.
//   quality[job]      half the root's surface area, cells times metres; then a part each REFIT_COST_TEXELS children
#include "lib/refit.glsl"

layout(local_size_x = 64) in;  // REFIT_THREADS
layout(set = 0, binding = SLOT_REFIT_QUALITY, std430) buffer Quality { uint quality[]; };

float halfArea(uvec3 box, vec3 cell) {
    precise vec3 e = vec3((box >> 16) - (box & 0xffffu)) * cell;
    precise float area = e.x * e.y + e.y * e.z + e.z * e.x;
    return area;
}

void main() {
    uint job = refitJob();
    uint index = refitIndex(job);
    if (index >= jobs[job].count) return;
    uint first = jobs[job].firstTexel;
    vec3 cell = jobs[job].gridCell.xyz;
    precise float sum = 0.0;
    if (index == 0u) {
        sum = halfArea(unitedCells(texelFetch(nodes, int(first)).xyz, texelFetch(nodes, int(first) + 1).xyz), cell);
    } else {
        uint end = first + min(index * REFIT_COST_TEXELS, jobs[job].texels);
        for (uint texel = first + (index - 1u) * REFIT_COST_TEXELS; texel < end; ++texel) {
            uvec4 child = texelFetch(nodes, int(texel));
            uint count = (child.w & BVH_LEAF) != 0u ? ((child.w >> BVH_COUNT_SHIFT) & 3u) + 1u : 1u;
            sum += halfArea(child.xyz, cell) * float(count);
        }
    }
    quality[jobs[job].quality + index] = floatBitsToUint(sum);
}
