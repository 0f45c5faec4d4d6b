// Irradiance at full resolution, between the four texels around each pixel; what they do not stand for is overwritten
// by upsample_place.comp.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/coarse_block.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = SLOT_GATHER_COARSE) uniform sampler2D coarse;
layout(set = 0, binding = SLOT_GATHER_IRRADIANCE, rgba16f) uniform writeonly image2D irradianceIndirect;

void main() {
    ivec2 block = ivec2(gl_GlobalInvocationID.xy);
    ivec2 first = firstPixel(block);
    if (any(greaterThanEqual(first, ivec2(view.width, view.height)))) return;
    vec3 texels[4];
    for (int i = 0; i < 4; ++i) texels[i] = min(texelFetch(coarse, texelOf(block, i), 0).rgb, vec3(65504.0));
    int divisor = int(params.divisor);
    vec2 span = blockSpan(block);
    for (int y = 0; y < divisor; ++y)
        for (int x = 0; x < divisor; ++x) {
            ivec2 pixel = first + ivec2(x, y);
            if (!inImage(pixel)) continue;
            vec4 weights = texelWeights(ivec2(x, y), span);
            vec3 irradiance = vec3(0.0);
            for (int i = 0; i < 4; ++i) irradiance += weights[i] * texels[i];
            imageStore(irradianceIndirect, pixel, vec4(irradiance, 1.0));
        }
}
