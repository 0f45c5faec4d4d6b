// How many of a few rays to random points of a sphere light reach it. Points under the surface's horizon do not count:
// the irradiance already leaves that part out.                                                                    [D4]
#ifndef LAMPYRIS_LIB_SHADOW_RAYS
#define LAMPYRIS_LIB_SHADOW_RAYS
#include "lib/bvh_walk.glsl"
#include "lib/ray_origin.glsl"
#include "lib/rng.glsl"
#include "lib/sampling.glsl"

// Uniform in the cone under which the sphere appears; where the horizon cuts it, what falls under is drawn anew, and
// at last the sphere's highest point over the surface stands in.
vec3 pointOnLight(vec3 toCentre, float radius, vec3 normal, vec2 xi, inout uvec2 random) {
    float sinSigma2 = radius * radius / dot(toCentre, toCentre);
    float cosCone = sqrt(max(0.0, 1.0 - sinSigma2));
    vec3 axis = normalize(toCentre);
    int attempts = dot(toCentre, normal) >= radius ? 1 : 4;
    for (int attempt = 0; attempt < attempts; ++attempt) {
        vec3 sampled = sampleCone(axis, cosCone, xi);
        if (dot(sampled, normal) > 0.0) return sampled;
        xi = random2(random);
    }
    return normalize(toCentre + normal * radius);
}

// Which ray comes i-th: first one of each pair of neighbours, so that half of the set is spread as evenly as the whole
// (of two numbers that differ in the last bit, the one of even parity).
uint rayInTurn(uint i, uint rays) {
    uint pairs = rays / 2u;
    if (i >= 2u * pairs) return i;
    uint pair = i % pairs;
    return 2u * pair + ((uint(bitCount(pair)) + i / pairs) & 1u);
}

// How many of `rays` see the light. enough: the first so many speak for all where they agree.
// shift: of the rays' set of points, on the unit square.
uint raysThatSee(GpuLight light, vec3 origin, vec3 normal, uint rays, uint enough, vec2 shift, inout uvec2 random) {
    vec3 toCentre = light.positionRadius.xyz - origin;
    float d2 = dot(toCentre, toCentre);
    float radius = light.positionRadius.w;
    if (d2 <= radius * radius) return rays;                // inside the light
    if (dot(toCentre, normal) <= -radius) return 0u;       // all of it under the horizon
    uint seen = 0u;
    for (uint i = 0u; i < rays; ++i) {
        if (i == enough && (seen == 0u || seen == enough)) return seen == 0u ? 0u : rays;
        vec2 xi = fract(hammersley(rayInTurn(i, rays), rays) + shift);
        vec3 direction = pointOnLight(toCentre, radius, normal, xi, random);
        // Up to the sphere's near side along this direction.
        float b = dot(direction, toCentre);
        if (!traceAny(origin, direction, 0.0, b - sqrt(max(0.0, b * b - d2 + radius * radius)))) ++seen;
    }
    return seen;
}

#endif
