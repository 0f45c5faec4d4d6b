// The listed pixels: from more texels around them, or where those do not stand for them either, by their own rays; and
// for final_alone.comp, 0 in alpha where it was by those.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/edge_list.glsl"
#include "lib/final_gather.glsl"
#include "lib/gather_grid.glsl"
#include "lib/joint_weight.glsl"
#include "lib/surface.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = SLOT_FINAL_COARSE_IN) uniform usampler2D coarse;
layout(set = 0, binding = SLOT_FINAL_GUIDE_IN) uniform usampler2D guide;
layout(set = 0, binding = SLOT_GATHER_IRRADIANCE, rgba16f) uniform writeonly image2D irradianceIndirect;

// [chosen] Texels to each side, and the least weight that they must have together.
const int kReach = 2;
const float kLeastWeight = 0.02;
// [chosen] For each ray of a texel: a pixel alone shares noise with fewer, and with no frame before.
const uint kRaysAlone = 2u;

void main() {
    uint place = listPlace();
    if (place >= counters.pixelsRecomputed) return;
    ivec2 pixel = listedPixel(place);
    float z = viewDepth(depthAt(pixel));
    vec3 position = positionWorld(pixel, depthAt(pixel));
    vec3 normal = normalAt(pixel);
    float spacing = pixelFootprint(z) * float(params.divisor);
    ivec2 nearest = pixel / int(params.divisor);
    vec4 sum = vec4(0.0);
    for (int y = -kReach; y <= kReach; ++y)
        for (int x = -kReach; x <= kReach; ++x) {
            ivec2 at = clamp(nearest + ivec2(x, y), ivec2(0), ivec2(params.coarseWidth, params.coarseHeight) - 1);
            vec2 away = vec2(representative(at) - pixel) / float(params.divisor);
            Place texel = placeOf(texelFetch(guide, at, 0));
            float weight = exp(-dot(away, away)) * jointWeight(position, normal, texel, spacing);
            CoarseLight light = unpackLight(texelFetch(coarse, at, 0));
            sum += weight * vec4(irradianceTowards(light.irradiance, relativeSlope(light), normal), 1.0);
        }
    vec3 irradiance = sum.rgb / max(sum.a, 1e-6);
    bool alone = sum.a < kLeastWeight;
    if (alone) {
        uvec2 random = seedRandom(uint(pixel.y) * view.width + uint(pixel.x), params.seed ^ 0x5bd1e995u);
        uint slot;
        uint rays = kRaysAlone * params.rays;
        irradiance = finalGather(position, z, normal, rays, params.emitterCount,
                                 GatherPoints(0u, random), slot).irradiance;
    }
    imageStore(irradianceIndirect, pixel, vec4(min(irradiance, vec3(65504.0)), alone ? 0.0 : 1.0));
}
