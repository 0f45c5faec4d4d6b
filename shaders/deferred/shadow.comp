// One shadow ray a pixel to a random point of each light that reaches it: bit set = in shadow.
// Points under the surface's horizon do not count: the irradiance already leaves that part out.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/bvh_walk.glsl"
#include "lib/rng.glsl"
#include "lib/sampling.glsl"
#include "lib/surface.glsl"
#include "shared/direct.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant) uniform Push { DirectParams params; };
layout(set = 0, binding = SLOT_LIGHTS, std430) readonly buffer Lights { GpuLight lights[]; };
layout(set = 0, binding = SLOT_LIGHT_MASKS, std430) readonly buffer Masks { uint masks[]; };
layout(set = 0, binding = SLOT_SHADOW_MASKS, r32ui) uniform writeonly uimage2DArray shadowMasks;

// Uniform in the cone under which the sphere appears; where the horizon cuts it, what falls under is drawn anew, and
// at last the sphere's highest point over the surface stands in.
vec3 pointOnLight(vec3 toCentre, float radius, vec3 normal, inout uvec2 random) {
    float sinSigma2 = radius * radius / dot(toCentre, toCentre);
    float cosCone = sqrt(max(0.0, 1.0 - sinSigma2));
    vec3 axis = normalize(toCentre);
    int attempts = dot(toCentre, normal) >= radius ? 1 : 4;
    for (int attempt = 0; attempt < attempts; ++attempt) {
        vec3 sampled = sampleCone(axis, cosCone, random2(random));
        if (dot(sampled, normal) > 0.0) return sampled;
    }
    return normalize(toCentre + normal * radius);
}

bool occluded(GpuLight light, vec3 origin, vec3 normal, inout uvec2 random) {
    vec3 toCentre = light.positionRadius.xyz - origin;
    float d2 = dot(toCentre, toCentre);
    float radius = light.positionRadius.w;
    if (d2 <= radius * radius) return false;                 // inside the light
    if (dot(toCentre, normal) <= -radius) return true;       // all of it under the horizon
    vec3 direction = pointOnLight(toCentre, radius, normal, random);
    // Up to the sphere's near side along this direction.
    float b = dot(direction, toCentre);
    return traceAny(origin, direction, 0.0, b - sqrt(max(0.0, b * b - d2 + radius * radius)));
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (!insideImage(pixel)) return;
    float depth = depthAt(pixel);
    uint tile = (uint(pixel.y) / TILE_PIXELS) * view.tilesX + uint(pixel.x) / TILE_PIXELS;
    vec3 normal = depth > 0.0 ? normalAt(pixel) : vec3(0.0);
    vec3 origin = vec3(0.0);
    if (depth > 0.0) {
        float z = viewDepth(depth);
        vec3 position = positionWorld(pixel, depth);
        // Clear of the surface by more than the depth buffer's and the triangles' rounding.
        origin = position + normal * (2e-4 * z + 1e-5 * length(position));
    }
    uvec2 random = seedRandom(uint(pixel.y) * view.width + uint(pixel.x), params.seed);
    for (uint word = 0u; word < params.maskWords; ++word) {
        uint shadowed = 0u;
        uint left = depth > 0.0 ? masks[(tile * 2u) * params.maskWords + word] : 0u;
        while (left != 0u) {
            uint bit = uint(findLSB(left));
            left &= left - 1u;
            GpuLight light = lights[word * 32u + bit];
            if (occluded(light, origin, normal, random)) shadowed |= 1u << bit;
        }
        imageStore(shadowMasks, ivec3(pixel, word), uvec4(shadowed));
    }
}
