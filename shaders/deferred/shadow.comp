// At low resolution: how many of a few shadow rays see each light that reaches the texel, and where the texel stands.
// A layer holds one bit of that number for 32 lights.
#version 460
#extension GL_GOOGLE_include_directive : require
#define COARSE_PARAMS DirectParams
#include "shared/direct.h"
#include "lib/gather_grid.glsl"
#include "lib/joint_weight.glsl"
#include "lib/shadow_rays.glsl"
#include "lib/surface.glsl"

// The sets of four texels in a square interleave to one of four times the points.
vec2 interleaved(ivec2 texel) {
    uint corner = uint(texel.x & 1) + 2u * uint(texel.y & 1);
    vec2 shift = vec2(seedRandom(params.seed, 0x3c6ef372u) & 0x00FFFFFFu) * kTwoToMinus24;
    return shift + vec2(float(corner) / 4.0, radicalInverse2(corner)) / float(params.rays);
}

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = SLOT_LIGHTS, std430) readonly buffer Lights { GpuLight lights[]; };
layout(set = 0, binding = SLOT_LIGHT_MASKS, std430) readonly buffer Masks { uint masks[]; };
layout(set = 0, binding = SLOT_SHADOW_COUNTS, r32ui) uniform writeonly uimage2DArray shadowCounts;
layout(set = 0, binding = SLOT_SHADOW_GUIDE, rgba32ui) uniform writeonly uimage2D guide;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (texel.x >= int(params.coarseWidth) || texel.y >= int(params.coarseHeight)) return;
    ivec2 pixel = representative(texel);
    float depth = depthAt(pixel);
    uint tile = (uint(pixel.y) / TILE_PIXELS) * view.tilesX + uint(pixel.x) / TILE_PIXELS;
    vec3 normal = vec3(0.0), origin = vec3(0.0);
    uvec4 place = kNoPlace;
    if (depth > 0.0) {
        normal = normalAt(pixel);
        vec3 position = positionWorld(pixel, depth);
        origin = clearOf(position, normal, viewDepth(depth));
        place = uvec4(floatBitsToUint(position), packDirection(normal));
    }
    imageStore(guide, texel, place);
    uvec2 random = seedRandom(uint(pixel.y) * view.width + uint(pixel.x), params.seed ^ 0x68bc21ebu);
    vec2 shift = interleaved(texel);
    for (uint word = 0u; word < params.maskWords; ++word) {
        uint bits[SHADOW_MOST_PLANES] = uint[SHADOW_MOST_PLANES](0u, 0u, 0u, 0u, 0u);
        uint left = depth > 0.0 ? masks[(tile * 2u) * params.maskWords + word] : 0u;
        while (left != 0u) {
            uint bit = uint(findLSB(left));
            left &= left - 1u;
            uint seen = raysThatSee(lights[word * 32u + bit], origin, normal, params.rays, params.rays, shift, random);
            for (uint k = 0u; k < SHADOW_MOST_PLANES; ++k) bits[k] |= ((seen >> k) & 1u) << bit;
        }
        for (uint k = 0u; k < params.planes; ++k)
            imageStore(shadowCounts, ivec3(texel, word * params.planes + k), uvec4(bits[k]));
    }
}
