// Irradiance at full resolution from the four texels around each pixel, by how far they stand for it; lists the pixels
// that none of them stands for.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/coarse_block.glsl"
#include "lib/coarse_light.glsl"
#include "lib/joint_weight.glsl"
#include "lib/surface.glsl"
#include "shared/photon.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = SLOT_FINAL_COARSE_IN) uniform usampler2D coarse;
layout(set = 0, binding = SLOT_FINAL_GUIDE_IN) uniform usampler2D guide;
layout(set = 0, binding = SLOT_GATHER_IRRADIANCE, rgba16f) uniform writeonly image2D irradianceIndirect;
layout(set = 0, binding = SLOT_GATHER_LIST, std430) writeonly buffer List { uint list[]; };
layout(set = 0, binding = SLOT_GATHER_COUNTERS, std430) buffer Counters { FrameCounters counters; };

// [chosen] Of the weight that texels on the pixel's own plane would have.
const float kLeastWeight = 0.05;

void main() {
    ivec2 block = ivec2(gl_GlobalInvocationID.xy);
    ivec2 first = firstPixel(block);
    if (any(greaterThanEqual(first, ivec2(view.width, view.height)))) return;
    vec3 irradiances[4], slopes[4];
    Place places[4];
    for (int i = 0; i < 4; ++i) {
        CoarseLight light = unpackLight(texelFetch(coarse, texelOf(block, i), 0));
        irradiances[i] = light.irradiance;
        slopes[i] = relativeSlope(light);
        places[i] = placeOf(texelFetch(guide, texelOf(block, i), 0));
    }
    int divisor = int(params.divisor);
    vec2 span = blockSpan(block);
    for (int y = 0; y < divisor; ++y)
        for (int x = 0; x < divisor; ++x) {
            ivec2 pixel = first + ivec2(x, y);
            if (!inImage(pixel)) continue;
            float depth = depthAt(pixel);
            vec3 sum = vec3(0.0);
            if (depth > 0.0) {
                vec3 position = positionWorld(pixel, depth);
                vec3 normal = normalAt(pixel);
                float spacing = pixelFootprint(viewDepth(depth)) * float(divisor);
                vec4 weights = texelWeights(ivec2(x, y), span);
                float total = 0.0;
                for (int i = 0; i < 4; ++i) {
                    float weight = weights[i] * jointWeight(position, normal, places[i], spacing);
                    sum += weight * irradianceTowards(irradiances[i], slopes[i], normal);
                    total += weight;
                }
                sum /= max(total, 1e-6);
                if (total < kLeastWeight)
                    list[atomicAdd(counters.pixelsRecomputed, 1u)] = uint(pixel.x) | (uint(pixel.y) << 16);
            }
            imageStore(irradianceIndirect, pixel, vec4(min(sum, vec3(65504.0)), 1.0));
        }
}
