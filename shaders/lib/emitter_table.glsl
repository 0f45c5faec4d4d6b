// The emissive triangles: drawing one by power, and finding one that a ray met.
#ifndef LAMPYRIS_LIB_EMITTER_TABLE
#define LAMPYRIS_LIB_EMITTER_TABLE
#include "shared/scene.h"

layout(set = 0, binding = SLOT_EMITTERS, std430) readonly buffer Emitters { GpuEmitter emitters[]; };
layout(set = 0, binding = SLOT_EMITTER_TRIANGLES) uniform samplerBuffer emitterTriangles;

vec4 emitterTexel(uint triangle, uint texel) {
    return texelFetch(emitterTriangles, int(triangle * EMITTER_TEXELS + texel));
}

// Of count triangles the first whose cumulative share, the w of that texel, exceeds xi.
uint triangleByShare(uint first, uint count, uint texel, float xi) {
    uint low = first, high = first + count - 1u;
    while (low < high) {
        uint middle = (low + high) / 2u;
        if (emitterTexel(middle, texel).w > xi) high = middle;
        else low = middle + 1u;
    }
    return low;
}

// A point that is uniform over a triangle.
vec3 pointOfTriangle(uint triangle, vec2 xi) {
    float root = sqrt(xi.x);
    return emitterTexel(triangle, 0u).xyz + (1.0 - root) * emitterTexel(triangle, 1u).xyz +
           root * xi.y * emitterTexel(triangle, 2u).xyz;
}

// Where the table of emitterCount instances has a triangle of the scene; SCENE_NONE where it has no power.
uint emitterTriangleOf(uint emitterCount, uint instance, uint primitive) {
    uint low = 0u, high = emitterCount;
    while (low < high) {
        uint middle = (low + high) / 2u;
        if (emitters[middle].instance < instance) low = middle + 1u;
        else high = middle;
    }
    if (low == emitterCount || emitters[low].instance != instance) return SCENE_NONE;
    uint end = emitters[low].firstTriangle + emitters[low].triangleCount;
    low = emitters[low].firstTriangle;
    high = end;
    while (low < high) {
        uint middle = (low + high) / 2u;
        if (floatBitsToUint(emitterTexel(middle, 0u).w) < primitive) low = middle + 1u;
        else high = middle;
    }
    return low < end && floatBitsToUint(emitterTexel(low, 0u).w) == primitive ? low : SCENE_NONE;
}

// Probability for each square metre of a triangle that a draw by power over the whole table ends there: of the shares
// as they were rounded. Draws have 24 bits: of a share below 2^-24 a little light is lost.
float emitterDensity(uint triangle) {
    float before = triangle > 0u ? emitterTexel(triangle - 1u, 3u).w : 0.0;
    return (emitterTexel(triangle, 3u).w - before) / max(emitterTexel(triangle, 2u).w, 1e-30);
}

#endif
