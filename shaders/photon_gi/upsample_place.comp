// The listed pixels' own estimates, over what was interpolated there. HALF_ESTIMATES: as final_alone.comp packs them.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/edge_list.glsl"

layout(local_size_x = 64) in;
#ifdef HALF_ESTIMATES
layout(set = 0, binding = SLOT_GATHER_ESTIMATES, std430) readonly buffer Estimates { uvec2 estimates[]; };
vec3 estimate(uint place) {
    return vec3(unpackHalf2x16(estimates[place].x), unpackHalf2x16(estimates[place].y).x);
}
#else
layout(set = 0, binding = SLOT_GATHER_ESTIMATES, std430) readonly buffer Estimates { vec4 estimates[]; };
vec3 estimate(uint place) { return min(estimates[place].rgb, vec3(65504.0)); }
#endif
layout(set = 0, binding = SLOT_GATHER_IRRADIANCE, rgba16f) uniform writeonly image2D irradianceIndirect;

void main() {
    uint place = listPlace();
    if (place >= counters.pixelsRecomputed) return;
    imageStore(irradianceIndirect, listedPixel(place), vec4(estimate(place), 1.0));
}
