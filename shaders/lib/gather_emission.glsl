// Irradiance that comes straight from emissive triangles. Rays by the cosine that happen to meet one make sparks where
// it is small; samples of the triangles do so where it is near. The balance heuristic adds up both [Veach 1995]:
//   E = Σ Le cos / (n cos/π + m p),   n rays and m samples; p, density of the samples by solid angle                [F5]
#ifndef LAMPYRIS_LIB_GATHER_EMISSION
#define LAMPYRIS_LIB_GATHER_EMISSION
#include "lib/bvh_walk.glsl"
#include "lib/coarse_light.glsl"
#include "lib/emitter_table.glsl"
#include "lib/rng.glsl"
#include "lib/sampling.glsl"

struct GatherMix {
    uint rays;
    uint samples;
    uint emitterCount;  // instances
};

// What one ray or sample adds that met `triangle` of the table, or SCENE_NONE.
vec3 emissionShare(Hit hit, vec3 direction, vec3 normal, uint triangle, GatherMix mixed) {
    float cosine = max(dot(normal, direction), 0.0);
    float density = 0.0;
    if (triangle != SCENE_NONE)
        density = emitterDensity(triangle) * hit.t * hit.t / max(abs(dot(hit.normalWorld, direction)), 1e-20);
    float total = float(mixed.rays) * cosine / kPi + float(mixed.samples) * density;
    return hitEmission(hit, direction) * (cosine / max(total, 1e-30));
}

// Of a ray by the cosine.
vec3 emissionMet(Hit hit, vec3 direction, vec3 normal, GatherMix mixed) {
    if ((instances[hit.instance].flags & INSTANCE_EMISSIVE) == 0u) return vec3(0.0);
    uint triangle =
        mixed.samples > 0u ? emitterTriangleOf(mixed.emitterCount, hit.instance, hit.primitive) : SCENE_NONE;
    return emissionShare(hit, direction, normal, triangle, mixed);
}

// Of all samples: each a triangle by power, a point of it, and a ray there that must meet just that triangle.
void addEmissionSampled(inout CoarseLight light, vec3 origin, vec3 normal, GatherMix mixed, uint firstSample,
                        uvec2 seed) {
    uint triangleCount = 0u;
    if (mixed.samples > 0u) {
        GpuEmitter last = emitters[mixed.emitterCount - 1u];
        triangleCount = last.firstTriangle + last.triangleCount;
    }
    uvec2 scramble = tea(seed, 8);
    for (uint i = 0u; i < mixed.samples; ++i) {
        vec2 xi = sobol2(firstSample + i, scramble);
        uvec2 random = seedRandom(firstSample + i, scramble.x);
        uint triangle = triangleByShare(0u, triangleCount, 3u, xi.x);
        vec3 to = pointOfTriangle(triangle, vec2(xi.y, random2(random).x)) - origin;
        vec3 direction = normalize(to);
        Hit hit;
        if (dot(normal, to) <= 0.0 || !traceClosest(origin, direction, 0.0, 1e30, hit)) continue;
        if (emitterTriangleOf(mixed.emitterCount, hit.instance, hit.primitive) == triangle)
            addLight(light, emissionShare(hit, direction, normal, triangle, mixed), direction, normal);
    }
}

#endif
