// Shares of the lights that each shadow texel sees. In a penumbra wider than texels the rays of those around count too:
// four in a square have one set of points between them, so that no pattern of theirs is left.                    [D7]
#version 460
#extension GL_GOOGLE_include_directive : require
#define COARSE_PARAMS DirectParams
#include "shared/direct.h"
#include "lib/gather_grid.glsl"
#include "lib/joint_weight.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = SLOT_LIGHT_MASKS, std430) readonly buffer Masks { uint masks[]; };
layout(set = 0, binding = SLOT_SHADOW_COUNTS) uniform usampler2DArray shadowCounts;
layout(set = 0, binding = SLOT_SHADOW_GUIDE) uniform usampler2D guide;
layout(set = 0, binding = SLOT_SHADOW_SHARES, r32ui) uniform writeonly uimage2DArray shadowShares;

uint countsPlane(ivec2 texel, uint word, uint plane) {
    return texelFetch(shadowCounts, ivec3(texel, word * params.planes + plane), 0).r;
}

uint tracedLights(ivec2 texel, uint word) {
    uvec2 tile = uvec2(representative(texel)) / TILE_PIXELS;
    return masks[((tile.y * view.tilesX + tile.x) * 2u) * params.maskWords + word];
}

float countedShare(ivec2 texel, uint word, uint bit) {
    uint seen = 0u;
    for (uint k = 0u; k < params.planes; ++k) seen |= ((countsPlane(texel, word, k) >> bit) & 1u) << k;
    return float(seen) / float(params.rays);
}

ivec2 neighbour(ivec2 texel, int i) { return texel + ivec2(i % 3, i / 3) - 1; }

// How much each texel of a square of nine counts for its middle one's surface.
void neighbourWeights(ivec2 texel, Place own, out float weights[9]) {
    float z = -(view.worldToView * vec4(own.position, 1.0)).z;
    float spacing = pixelFootprint(z) * float(params.divisor);
    ivec2 size = ivec2(params.coarseWidth, params.coarseHeight);
    for (int i = 0; i < 9; ++i) {
        ivec2 at = neighbour(texel, i);
        bool inside = all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, size));
        Place other = placeOf(texelFetch(guide, clamp(at, ivec2(0), size - 1), 0));
        float tent = float((2 - abs(i % 3 - 1)) * (2 - abs(i / 3 - 1)));
        weights[i] = inside ? tent * sameSurface(own.position, own.normal, other, spacing) : 0.0;
    }
}

float penumbraShare(ivec2 texel, uint word, uint bit, float weights[9]) {
    float own = countedShare(texel, word, bit);
    float sum = 0.0, total = 0.0, least = own, most = own;
    for (int i = 0; i < 9; ++i) {
        ivec2 at = neighbour(texel, i);
        if (weights[i] <= 0.0 || ((tracedLights(at, word) >> bit) & 1u) == 0u) continue;
        float share = countedShare(at, word, bit);
        sum += weights[i] * share;
        total += weights[i];
        least = min(least, share);
        most = max(most, share);
    }
    return most - least > kMostApart ? own : sum / total;
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (texel.x >= int(params.coarseWidth) || texel.y >= int(params.coarseHeight)) return;
    Place own = placeOf(texelFetch(guide, texel, 0));
    bool weighed = false;
    float weights[9];
    for (uint word = 0u; word < params.maskWords; ++word) {
        uint byAll = 0xffffffffu, bySome = 0u;  // lights that every ray sees, that some ray sees
        for (uint k = 0u; k < params.planes; ++k) {
            uint seen = countsPlane(texel, word, k);
            byAll &= ((params.rays >> k) & 1u) != 0u ? seen : ~seen;
            bySome |= seen;
        }
        uint shares[SHARE_PLANES];
        for (uint k = 0u; k < SHARE_PLANES; ++k) shares[k] = byAll;
        uint left = bySome & ~byAll;
        if (left != 0u && !weighed) neighbourWeights(texel, own, weights);
        weighed = weighed || left != 0u;
        while (left != 0u) {
            uint bit = uint(findLSB(left));
            left &= left - 1u;
            uint share = uint(round(penumbraShare(texel, word, bit, weights) * float(SHARE_WHOLE)));
            for (uint k = 0u; k < SHARE_PLANES; ++k) shares[k] |= ((share >> k) & 1u) << bit;
        }
        for (uint k = 0u; k < SHARE_PLANES; ++k)
            imageStore(shadowShares, ivec3(texel, word * SHARE_PLANES + k), uvec4(shares[k]));
    }
}
