// How much of a place's indirect light may have changed since the frame before, as a share of it.               [H1]
//   boxes   Σ r²/(r² + d²) · min(1, moved/r): what a ball of radius r hides of the directions, and how much of it is new
//   lights  Σ (changed + Φ · min(1, moved/d)) / d²  over  Σ Φ / d²
#ifndef LAMPYRIS_LIB_SCENE_CHANGE
#define LAMPYRIS_LIB_SCENE_CHANGE
#include "shared/history.h"

layout(set = 0, binding = SLOT_HISTORY_CHANGES, std430) readonly buffer Changes { ChangedPlace changes[]; };

float changeByRegions(vec3 position, uint count) {
    float change = 0.0;
    for (uint i = 0u; i < count; ++i) {
        vec3 lower = changes[i].lowerMoved.xyz, upper = changes[i].upperWatts.xyz;
        vec3 away = position - clamp(position, lower, upper);
        float radius = max(0.5 * length(upper - lower), 1e-6);
        float hides = radius * radius / (radius * radius + dot(away, away));
        change += hides * min(changes[i].lowerMoved.w / radius, 1.0);
    }
    return change;
}

float changeByLights(vec3 position, uint first, uint count) {
    float changed = 0.0, all = 1e-30;
    for (uint i = first; i < first + count; ++i) {
        vec3 away = position - changes[i].lowerMoved.xyz;
        float watts = changes[i].upperWatts.w;
        // [chosen] Indirect light comes from around a light, not from the light: no nearer than a metre.
        float square = dot(away, away) + 1.0;
        changed += (changes[i].changedWatts.x + watts * min(changes[i].lowerMoved.w * inversesqrt(square), 1.0)) / square;
        all += watts / square;
    }
    return changed / all;
}

#endif
