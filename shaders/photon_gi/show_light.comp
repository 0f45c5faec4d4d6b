// The parts of the picture one can ask for: direct and indirect radiance, irradiance of either, edges.
#version 460
#extension GL_GOOGLE_include_directive : require
#define SURFACE_MATERIAL
#include "lib/sampling.glsl"
#include "lib/surface.glsl"
#include "shared/show_light.h"

layout(constant_id = 0) const uint kWhat = SHOW_DIRECT;

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = SLOT_SHOWN_IRRADIANCE) uniform sampler2D irradiance;
layout(set = 0, binding = SLOT_SHOWN_SPECULAR) uniform sampler2D specular;
layout(set = 0, binding = SLOT_SHOWN_LIGHT, rgba32f) uniform writeonly image2D shown;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (!insideImage(pixel)) return;
    vec3 value = vec3(0.0);
    if (depthAt(pixel) > 0.0) {
        value = texelFetch(irradiance, pixel, 0).rgb;
        if (kWhat == SHOW_DIRECT || kWhat == SHOW_INDIRECT) value *= texelFetch(surfaceAlbedo, pixel, 0).rgb / kPi;
        if (kWhat == SHOW_DIRECT) value += texelFetch(specular, pixel, 0).rgb;
    }
    imageStore(shown, pixel, vec4(value, 1.0));
}
