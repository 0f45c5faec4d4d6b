// Direct light of all sphere lights that reach the tile, each by the share of it that the shadow texels around the
// pixel see: diffuse irradiance (no albedo) and specular radiance. Lists the pixels whose texels cannot say: other
// surfaces, or one that sees all of a light beside one that sees none.                                             [D5]
#version 460
#extension GL_GOOGLE_include_directive : require
#define COARSE_PARAMS DirectParams
#include "lib/shade_direct.glsl"
#include "lib/coarse_block.glsl"
#include "lib/joint_weight.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = SPEC_MANY_LIGHTS) const uint kManyLights = 1u;
layout(constant_id = SPEC_SHADOW_PLANES) const uint kPlanes = SHADOW_MOST_PLANES;
layout(set = 0, binding = SLOT_SHADOW_COUNTS) uniform usampler2DArray shadowCounts;
layout(set = 0, binding = SLOT_SHADOW_GUIDE) uniform usampler2D guide;
layout(set = 0, binding = SLOT_SHADOW_LIST, std430) writeonly buffer List { uint list[]; };
layout(set = 0, binding = SLOT_SHADOW_LISTED, std430) buffer Listed { uint listed; };

// [chosen] Of the weight that texels on the pixel's own plane would have.
const float kLeastWeight = 0.05;

// Bits of how many rays saw each light of a word; a component a texel.
struct Counts {
    uvec4 plane[SHADOW_MOST_PLANES];
};

Counts countsOf(ivec2 block, uint word) {
    Counts counts;
    for (uint k = 0u; k < SHADOW_MOST_PLANES; ++k) {
        counts.plane[k] = uvec4(0u);
        if (k < kPlanes)
            for (int i = 0; i < 4; ++i)
                counts.plane[k][i] = texelFetch(shadowCounts, ivec3(texelOf(block, i), word * kPlanes + k), 0).r;
    }
    return counts;
}

uint anyOf(uvec4 bits) { return bits.x | bits.y | bits.z | bits.w; }

// Lights that one of the texels sees whole and another not at all.
uint lightsInDoubt(Counts counts, uvec4 texels) {
    uvec4 none = texels, all = texels;
    for (uint k = 0u; k < kPlanes; ++k) {
        none &= ~counts.plane[k];
        all &= ((params.rays >> k) & 1u) != 0u ? counts.plane[k] : ~counts.plane[k];
    }
    return anyOf(none) & anyOf(all);
}

float shareSeen(Counts counts, vec4 weights, uint bit) {
    float sum = 0.0;
    for (uint k = 0u; k < kPlanes; ++k)
        sum += float(1u << k) * dot(weights, vec4((counts.plane[k] >> bit) & 1u));
    return sum / float(params.rays);
}

// False where the texels do not stand for the pixel.
bool shade(inout ShadedPixel p, ivec2 block, Counts first, vec4 weights) {
    float total = dot(weights, vec4(1.0));
    weights /= max(total, 1e-6);
    uvec4 texels = uvec4(greaterThan(weights, vec4(kLeastWeight))) * 0xffffffffu;
    uint doubt = 0u;
    for (uint word = 0u; word < params.maskWords; ++word) {
        uint left = masks[(p.tile * 2u) * params.maskWords + word];
        Counts counts = first;
        if (kManyLights != 0u && word > 0u) counts = countsOf(block, word);
        doubt |= left & lightsInDoubt(counts, texels);
        while (left != 0u) {
            uint bit = uint(findLSB(left));
            left &= left - 1u;
            addLight(p, word * 32u + bit, shareSeen(counts, weights, bit));
        }
    }
    return total >= kLeastWeight && doubt == 0u;
}

void main() {
    ivec2 block = ivec2(gl_GlobalInvocationID.xy);
    ivec2 first = firstPixel(block);
    if (any(greaterThanEqual(first, ivec2(view.width, view.height)))) return;
    Place places[4];
    for (int i = 0; i < 4; ++i) places[i] = placeOf(texelFetch(guide, texelOf(block, i), 0));
    Counts counts = countsOf(block, 0u);
    int divisor = int(params.divisor);
    vec2 span = blockSpan(block);
    for (int y = 0; y < divisor; ++y)
        for (int x = 0; x < divisor; ++x) {
            ivec2 pixel = first + ivec2(x, y);
            if (!inImage(pixel)) continue;
            float depth = depthAt(pixel);
            ShadedPixel p;
            p.irradiance = p.specular = vec3(0.0);
            if (depth > 0.0) {
                p = beginPixel(pixel, depth);
                float spacing = pixelFootprint(viewDepth(depth)) * float(divisor);
                vec4 weights = texelWeights(ivec2(x, y), span);
                for (int i = 0; i < 4; ++i) weights[i] *= jointWeight(p.position, p.normal, places[i], spacing);
                if (!shade(p, block, counts, weights))
                    list[atomicAdd(listed, 1u)] = uint(pixel.x) | (uint(pixel.y) << 16);
            }
            storePixel(pixel, p.irradiance, p.specular);
        }
}
