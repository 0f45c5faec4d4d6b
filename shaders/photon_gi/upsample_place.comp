// The listed pixels' own estimates, over what was interpolated there.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/edge_list.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = SLOT_GATHER_ESTIMATES, std430) readonly buffer Estimates { vec4 estimates[]; };
layout(set = 0, binding = SLOT_GATHER_IRRADIANCE, rgba16f) uniform writeonly image2D irradianceIndirect;

void main() {
    uint place = listPlace();
    if (place >= counters.pixelsRecomputed) return;
    imageStore(irradianceIndirect, listedPixel(place), vec4(min(estimates[place].rgb, vec3(65504.0)), 1.0));
}
