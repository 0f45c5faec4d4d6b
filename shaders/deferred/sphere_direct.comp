// Direct light of all sphere lights that reach the tile, each by the share of it that the shadow texels around the
// pixel see: diffuse irradiance (no albedo) and specular radiance. Lists the pixels whose texels cannot say, with the
// lights that are left out: all where the texels are of other surfaces, else those whose shares are too different for
// what lies between them.                                                                                          [D5]
#version 460
#extension GL_GOOGLE_include_directive : require
#define COARSE_PARAMS DirectParams
#include "lib/shade_direct.glsl"
#include "lib/coarse_block.glsl"
#include "lib/joint_weight.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = SPEC_MANY_LIGHTS) const uint kManyLights = 1u;
layout(set = 0, binding = SLOT_SHADOW_SHARES) uniform usampler2DArray shadowShares;
layout(set = 0, binding = SLOT_SHADOW_GUIDE) uniform usampler2D guide;
layout(set = 0, binding = SLOT_SHADOW_LIST, std430) writeonly buffer List { uvec2 list[]; };
layout(set = 0, binding = SLOT_SHADOW_LISTED, std430) buffer Listed { uint listed; };

// [measured] Of the weight that texels on the pixel's own plane would have. With less, narrow shadows along the foot
// of things are lost between texels: two_rooms, MSE 1.8 at 0.05, 1.2 at 0.6, 1.0 at 0.9 for twice the rays.
const float kLeastWeight = 0.6;

// Bits of how much of each light of a word is seen, and whether any ray was sent; a component a texel.
struct Shares {
    uvec4 plane[SHARE_PLANES];
    uvec4 traced;
};

Shares sharesOf(ivec2 block, uint word) {
    Shares shares;
    for (uint k = 0u; k < SHARE_PLANES; ++k)
        for (int i = 0; i < 4; ++i)
            shares.plane[k][i] = texelFetch(shadowShares, ivec3(texelOf(block, i), word * SHARE_PLANES + k), 0).r;
    for (int i = 0; i < 4; ++i) {
        uvec2 tile = uvec2(representative(texelOf(block, i))) / TILE_PIXELS;
        shares.traced[i] = masks[((tile.y * view.tilesX + tile.x) * 2u) * params.maskWords + word];
    }
    return shares;
}

// Shares of a light that the texels see.
vec4 sharesSeen(Shares shares, uint bit) {
    uvec4 seen = uvec4(0u);
    for (uint k = 0u; k < SHARE_PLANES; ++k) seen |= ((shares.plane[k] >> bit) & 1u) << k;
    return vec4(seen) / float(SHARE_WHOLE);
}

// Whether texels of the same surface differ more than a penumbra wider than they are makes them: then its edge lies
// between them.
bool inDoubt(vec4 shares, bvec4 same) {
    vec4 least = mix(vec4(1.0), shares, same), most = mix(vec4(0.0), shares, same);
    return max(max(most.x, most.y), max(most.z, most.w)) - min(min(least.x, least.y), min(least.z, least.w)) > kMostApart;
}

const uint kAll = 0xffffffffu;

// Adds the lights that the texels speak for; returns those that are left, of the first word; with more words, all.
uint shade(inout ShadedPixel p, ivec2 block, Shares first, vec4 weights) {
    float sum = dot(weights, vec4(1.0));
    bool alone = sum < kLeastWeight;
    bvec4 same = greaterThan(weights, vec4(0.05) * sum);
    uint doubted = 0u;
    for (uint word = 0u; word < params.maskWords; ++word) {
        uint left = masks[(p.tile * 2u) * params.maskWords + word];
        Shares ofWord = first;
        if (kManyLights != 0u && word > 0u) ofWord = sharesOf(block, word);
        while (left != 0u) {
            uint bit = uint(findLSB(left));
            left &= left - 1u;
            if (!gives(p, word * 32u + bit)) continue;
            vec4 shares = sharesSeen(ofWord, bit);
            uvec4 traced = (ofWord.traced >> bit) & 1u;
            if (alone || inDoubt(shares, same) || any(greaterThan(uvec4(same), traced)))
                doubted |= 1u << bit;  // of more words all are left
            else
                addLight(p, word * 32u + bit, dot(weights, shares) / sum);  // not alone: not 0
        }
    }
    if (kManyLights != 0u && doubted != 0u) {
        p.irradiance = p.specular = vec3(0.0);
        return kAll;
    }
    return doubted;
}

void main() {
    ivec2 block = ivec2(gl_GlobalInvocationID.xy);
    ivec2 first = firstPixel(block);
    if (any(greaterThanEqual(first, ivec2(view.width, view.height)))) return;
    Place places[4];
    for (int i = 0; i < 4; ++i) places[i] = placeOf(texelFetch(guide, texelOf(block, i), 0));
    Shares shares = sharesOf(block, 0u);
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
                for (int i = 0; i < 4; ++i) weights[i] *= sameSurface(p.position, p.normal, places[i], spacing);
                uint left = shade(p, block, shares, weights);
                if (left != 0u) list[atomicAdd(listed, 1u)] = uvec2(uint(pixel.x) | (uint(pixel.y) << 16), left);
            }
            storePixel(pixel, p.irradiance, p.specular);
        }
}
