// The G-buffer as images one can look at: albedo, normal, world position, view depth, emission.
#version 460
#extension GL_GOOGLE_include_directive : require
#define SURFACE_MATERIAL
#include "lib/surface.glsl"
#include "shared/direct.h"

layout(constant_id = 0) const uint kWhat = SHOW_ALBEDO;

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = SLOT_SHOWN, rgba32f) uniform writeonly image2D shown;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (!insideImage(pixel)) return;
    float depth = depthAt(pixel);
    vec3 value = vec3(0.0);
    if (depth > 0.0) {
        if (kWhat == SHOW_ALBEDO) value = texelFetch(surfaceAlbedo, pixel, 0).rgb;
        if (kWhat == SHOW_NORMAL) value = normalAt(pixel);
        if (kWhat == SHOW_POSITION) value = positionWorld(pixel, depth);
        if (kWhat == SHOW_DEPTH) value = vec3(viewDepth(depth));
        if (kWhat == SHOW_EMISSION) value = unpackSharedExponent(texelFetch(surfaceEmission, pixel, 0).r);
    }
    imageStore(shown, pixel, vec4(value, 1.0));
}
