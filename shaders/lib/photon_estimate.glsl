// Irradiance at a point from the photons of its tile: equation 5.6 of the Thesis without albedo,
//   E = Σ Φ (1 − d/r) / ((1 − 2/3) π r²)                     [G1]
// with the cone filter of constant k = 1. No cosine: the photons' density carries it. Photons that travel with
// the normal came from behind the surface and are left out.
#ifndef LAMPYRIS_LIB_PHOTON_ESTIMATE
#define LAMPYRIS_LIB_PHOTON_ESTIMATE
#include "lib/gather_grid.glsl"
#include "lib/photon.glsl"
#include "lib/surface.glsl"

layout(set = 0, binding = SLOT_BIN_PHOTONS) uniform usamplerBuffer gatherPhotons;
layout(set = 0, binding = SLOT_GATHER_INDICES) uniform usamplerBuffer gatherIndices;
layout(set = 0, binding = SLOT_BIN_RANGES, std430) readonly buffer Ranges { uvec2 ranges[]; };

vec3 irradianceEstimate(uvec2 tile, vec3 position, vec3 normal) {
    uvec2 range = ranges[tile.y * view.tilesX + tile.x];
    float radius2 = params.radius * params.radius;
    float inverseRadius = 1.0 / params.radius;
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < range.y; ++i) {
        int texel = int(texelFetch(gatherIndices, int(range.x + i)).x * 2u);
        uvec4 a = texelFetch(gatherPhotons, texel);
        vec3 to = photonPosition(a) - position;
        float d2 = dot(to, to);
        if (d2 >= radius2) continue;
        uvec4 b = texelFetch(gatherPhotons, texel + 1);
        if (dot(photonDirection(b), normal) >= 0.0) continue;
        sum += photonPower(a, b) * (1.0 - sqrt(d2) * inverseRadius);
    }
    const float kCone = 1.0 - 2.0 / 3.0;
    return sum * (params.powerScale / (kCone * 3.14159265 * radius2));
}

#endif
