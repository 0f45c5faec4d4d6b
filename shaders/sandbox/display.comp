// Exposure, tone map, sRGB, 8 bits: the twin of core::toDisplay.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/display.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant) uniform Push { DisplayParams params; };
layout(set = 0, binding = SLOT_DISPLAY_RADIANCE) uniform sampler2D radiance;
layout(set = 0, binding = SLOT_DISPLAY_SHOWN, rgba8) uniform writeonly image2D shown;

vec3 filmic(vec3 x) { return clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0); }

vec3 encodeSrgb(vec3 x) {
    return mix(1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, 12.92 * x, lessThanEqual(x, vec3(0.0031308)));
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(shown)))) return;
    vec3 exposed = params.gain * texelFetch(radiance, pixel, 0).rgb;
    vec3 safe = mix(max(exposed, 0.0), vec3(0.0), isnan(exposed));
    vec3 mapped = params.tonemap == DISPLAY_FILMIC ? filmic(safe) : min(safe, 1.0);
    imageStore(shown, pixel, vec4(encodeSrgb(mapped), 1.0));
}
