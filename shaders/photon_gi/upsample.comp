// Irradiance at full resolution: listed pixels take their own estimate, all others the four texels around them.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/coarse_taps.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = SLOT_GATHER_COARSE) uniform sampler2D coarse;
layout(set = 0, binding = SLOT_GATHER_EDGES) uniform usampler2D edges;
layout(set = 0, binding = SLOT_GATHER_ESTIMATES, std430) readonly buffer Estimates { vec4 estimates[]; };
layout(set = 0, binding = SLOT_GATHER_IRRADIANCE, rgba16f) uniform writeonly image2D irradianceIndirect;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (!insideImage(pixel)) return;
    vec3 irradiance = vec3(0.0);
    if (depthAt(pixel) > 0.0) {
        uint place = texelFetch(edges, pixel, 0).r;
        if (place > 0u) {
            irradiance = estimates[place - 1u].rgb;
        } else {
            CoarseTaps taps = coarseTaps(pixel);
            for (int i = 0; i < 4; ++i) irradiance += taps.weights[i] * texelFetch(coarse, taps.texels[i], 0).rgb;
        }
    }
    imageStore(irradianceIndirect, pixel, vec4(min(irradiance, vec3(65504.0)), 1.0));
}
