// Irradiance at a point by a few rays into the irradiance grid: each is a last bounce.
//   E = (1/n) Σ ρ(y) E(y),   y where ray i, drawn by the cosine, ends; and what comes from emitters [F5]          [F1]
#ifndef LAMPYRIS_LIB_FINAL_GATHER
#define LAMPYRIS_LIB_FINAL_GATHER
#include "lib/coarse_light.glsl"
#include "lib/gather_emission.glsl"
#include "lib/grid_look_up.glsl"
#include "lib/ray_origin.glsl"
#include "lib/sampling.glsl"

// Points of one scrambled sequence, a texel's from firstSample on.
struct GatherPoints {
    uint firstSample;
    uvec2 seed;
};

// firstSlot: of the grid, that the first ray looked up; slotMask + 1 if none.
CoarseLight finalGather(vec3 position, float viewDepth, vec3 normal, uint rays, uint emitterCount, GatherPoints points,
                        out uint firstSlot) {
    firstSlot = grid.slotMask + 1u;
    vec3 origin = clearOf(position, normal, viewDepth);
    GatherMix mixed = GatherMix(rays, emitterCount > 0u ? rays : 0u, emitterCount);
    CoarseLight light = CoarseLight(vec3(0.0), vec3(0.0), 1.0);
    for (uint i = 0u; i < rays; ++i) {
        vec3 direction = sampleCosine(normal, sobol2(points.firstSample + i, points.seed));
        Hit hit;
        if (!traceClosest(origin, direction, 0.0, 1e30, hit)) continue;
        Cell cell = cellOf(origin + hit.t * direction, storedNormal(hit.normalWorld), direction);
        uint slot;
        vec3 share = hitAlbedo(hit) * gridIrradiance(cell, slot) / float(rays);
        if (sceneEmission != 0u) share += emissionMet(hit, direction, normal, mixed);
        addLight(light, share, direction, normal);
        if (i == 0u) firstSlot = slot;
    }
    if (sceneEmission != 0u) addEmissionSampled(light, origin, normal, mixed, points.firstSample, points.seed);
    return light;
}

#endif
