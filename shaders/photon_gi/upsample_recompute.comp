// The estimate at full resolution for each listed pixel. ADD_TO_ESTIMATES: adds to what earlier batches gave.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/edge_list.glsl"
#include "lib/photon_estimate.glsl"

layout(local_size_x = 64) in;
#ifdef ADD_TO_ESTIMATES
layout(set = 0, binding = SLOT_GATHER_ESTIMATES, std430) buffer Estimates { vec4 estimates[]; };
#else
layout(set = 0, binding = SLOT_GATHER_ESTIMATES, std430) writeonly buffer Estimates { vec4 estimates[]; };
#endif

void main() {
    uint place = listPlace();
    if (place >= counters.pixelsRecomputed) return;
    ivec2 pixel = listedPixel(place);
    vec3 irradiance = irradianceEstimate(uvec2(pixel) / TILE_PIXELS, positionWorld(pixel, depthAt(pixel)), normalAt(pixel));
#ifdef ADD_TO_ESTIMATES
    irradiance += estimates[place].rgb;
#endif
    estimates[place] = vec4(irradiance, 1.0);
}
