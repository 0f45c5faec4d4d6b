#version 460
#extension GL_GOOGLE_include_directive : require
// Rewrites the triangles of one leaf from the posed vertices, and the leaf's box in its parent. A triangle without
// area or with a corner that is not finite gets zero corners and no box: it is never hit.
#include "lib/refit.glsl"
#include "lib/refit_stores.glsl"

layout(local_size_x = 64) in;  // REFIT_THREADS
layout(set = 0, binding = SLOT_REFIT_SLOTS) uniform usamplerBuffer slots;
layout(set = 0, binding = SLOT_REFIT_TRIANGLES) uniform usamplerBuffer triangles;
layout(set = 0, binding = SLOT_REFIT_POSITIONS) uniform samplerBuffer positions;
layout(set = 0, binding = SLOT_REFIT_INDICES) uniform usamplerBuffer indices;
layout(set = 0, binding = SLOT_REFIT_QUALITY, std430) buffer Quality { uint quality[]; };

#ifdef LARGE
layout(set = 0, binding = SLOT_REFIT_NEW_TRIANGLES, rgba32ui) uniform writeonly uimageBuffer newTriangles;
void putCorner(int texel, uvec4 corner) { imageStore(newTriangles, texel, corner); }
#else
layout(set = 0, binding = SLOT_REFIT_NEW_TRIANGLES, std430) writeonly buffer NewTriangles { uvec4 newTriangles[]; };
void putCorner(int texel, uvec4 corner) { newTriangles[texel] = corner; }
#endif

vec3 cornerAt(uint index, uint firstVertex) {
    return texelFetch(positions, int(texelFetch(indices, int(index)).x + firstVertex)).xyz;
}

// As accel::hasArea: the sum of the normal's absolute components is a normal float. By bits, as a comparison
// with what is not a number may be taken either way.
bool hasArea(vec3 v0, vec3 v1, vec3 v2) {
    precise vec3 a = v1 - v0, b = v2 - v0;
    precise vec3 n = a.yzx * b.zxy - b.yzx * a.zxy;
    precise float sum = abs(n.x) + abs(n.y) + abs(n.z);
    return floatBitsToUint(sum) - 0x00800000u < 0x7f000000u;
}

void main() {
    uint job = refitJob();
    uint index = refitIndex(job);
    if (index >= jobs[job].count) return;
    uint texel = jobs[job].firstTexel + texelFetch(slots, int(jobs[job].firstSlot + index)).x;
    uint link = texelFetch(nodes, int(texel)).w;
    uint next = link & BVH_INDEX_MASK;
    uint end = next + ((link >> BVH_COUNT_SHIFT) & 3u) + 1u;
    uint firstIndex = jobs[job].firstIndex, firstVertex = jobs[job].firstVertex;
    vec3 lower = vec3(3e38), upper = vec3(-3e38);
    uint dropped = end - next;
    uint all = dropped;
    for (; next < end; ++next) {
        int at = int(next * BVH_TRIANGLE_TEXELS);
        uint primitive = texelFetch(triangles, at).w;
        uint corner = firstIndex + 3u * primitive;
        vec3 v0 = cornerAt(corner, firstVertex);
        vec3 v1 = cornerAt(corner + 1u, firstVertex);
        vec3 v2 = cornerAt(corner + 2u, firstVertex);
        bool kept = hasArea(v0, v1, v2);
        uint mask = kept ? 0xffffffffu : 0u;
        putCorner(at, uvec4(floatBitsToUint(v0) & mask, primitive));
        putCorner(at + 1, uvec4(floatBitsToUint(v1) & mask, 0u));
        putCorner(at + 2, uvec4(floatBitsToUint(v2) & mask, 0u));
        dropped -= kept ? 1u : 0u;
        lower = kept ? min(lower, min(v0, min(v1, v2))) : lower;
        upper = kept ? max(upper, max(v0, max(v1, v2))) : upper;
    }
    uvec3 box = toCells(lower, upper, jobs[job].gridOffset.xyz, jobs[job].cellsPerMetre.xyz);
    putNode(texel, uvec4(dropped == all ? kNoBox : box, link));
    if (dropped > 0u) atomicAdd(quality[jobs[job].quality], dropped);
}
