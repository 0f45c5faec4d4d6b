// Irradiance at a point by a few rays into the irradiance grid: each is a last bounce.
//   E = (1/n) Σ ρ(y) E(y) + π Le(y),   y where ray i, drawn by the cosine, ends                                   [F1]
#ifndef LAMPYRIS_LIB_FINAL_GATHER
#define LAMPYRIS_LIB_FINAL_GATHER
#include "lib/grid_look_up.glsl"
#include "lib/sampling.glsl"

vec3 finalGather(vec3 position, float viewDepth, vec3 normal, uint rays, uvec2 random) {
    // Clear of the surface by more than the depth buffer's and the triangles' rounding.
    vec3 origin = position + normal * (2e-4 * viewDepth + 1e-5 * length(position));
    vec2 shift = random2(random);
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < rays; ++i) {
        vec3 direction = sampleCosine(normal, fract(hammersley(i, rays) + shift));
        Hit hit;
        if (!traceClosest(origin, direction, 0.0, 1e30, hit)) continue;
        Cell cell = cellOf(origin + hit.t * direction, storedNormal(hit.normalWorld), direction);
        sum += hitAlbedo(hit) * gridIrradiance(cell) + kPi * hitEmission(hit, direction);
    }
    return sum / float(rays);
}

#endif
