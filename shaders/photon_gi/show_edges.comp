// Pixels whose irradiance is estimated anew at full resolution: 1 over an image of zeros.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/edge_list.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = SLOT_GATHER_EDGES, rgba32f) uniform writeonly image2D shown;

void main() {
    uint place = listPlace();
    if (place < counters.pixelsRecomputed) imageStore(shown, listedPixel(place), vec4(1.0));
}
