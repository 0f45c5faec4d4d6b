// Direct light of all sphere lights that reach the tile, each by the share of it that the shadow texels around the
// pixel see: diffuse irradiance (no albedo) and specular radiance. Lists the pixels whose texels cannot say: other
// surfaces, or shares of a light too different for what lies between them.                                         [D5]
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

// [measured] Of the weight that texels on the pixel's own plane would have. With less, narrow shadows along the foot
// of things are lost between texels: two_rooms, MSE 1.8 at 0.05, 1.2 at 0.6, 1.0 at 0.9 for twice the rays.
const float kLeastWeight = 0.6;

// Bits of how many rays saw each light of a word, and whether any was sent; a component a texel.
struct Counts {
    uvec4 plane[SHADOW_MOST_PLANES];
    uvec4 traced;
};

Counts countsOf(ivec2 block, uint word) {
    Counts counts;
    for (uint k = 0u; k < SHADOW_MOST_PLANES; ++k) {
        counts.plane[k] = uvec4(0u);
        if (k < kPlanes)
            for (int i = 0; i < 4; ++i)
                counts.plane[k][i] = texelFetch(shadowCounts, ivec3(texelOf(block, i), word * kPlanes + k), 0).r;
    }
    for (int i = 0; i < 4; ++i) {
        uvec2 tile = uvec2(representative(texelOf(block, i))) / TILE_PIXELS;
        counts.traced[i] = masks[((tile.y * view.tilesX + tile.x) * 2u) * params.maskWords + word];
    }
    return counts;
}

// Shares of a light that the texels see.
vec4 sharesSeen(Counts counts, uint bit) {
    uvec4 seen = uvec4(0u);
    for (uint k = 0u; k < kPlanes; ++k) seen |= ((counts.plane[k] >> bit) & 1u) << k;
    return vec4(seen) / float(params.rays);
}

// Looser than jointWeight: what hides a light does not hang on a mapped normal, which may lean far from its neighbours'.
float sameSurface(vec3 position, vec3 normal, Place other, float spacing) {
    float off = abs(dot(normal, other.position - position)) / (1.5 * spacing);
    return dot(normal, other.normal) > 0.5 ? clamp(2.0 - 2.0 * off, 0.0, 1.0) : 0.0;
}

// Whether texels of the same surface differ more than a penumbra wider than they are makes them: then its edge lies
// between them. [chosen] Three rays of four.
bool inDoubt(vec4 shares, bvec4 same) {
    vec4 least = mix(vec4(1.0), shares, same), most = mix(vec4(0.0), shares, same);
    return max(max(most.x, most.y), max(most.z, most.w)) - min(min(least.x, least.y), min(least.z, least.w)) > 0.7;
}

// False where the texels do not stand for the pixel.
bool shade(inout ShadedPixel p, ivec2 block, Counts first, vec4 weights) {
    float total = dot(weights, vec4(1.0));
    weights /= max(total, 1e-6);
    bvec4 same = greaterThan(weights, vec4(0.05));
    bool doubt = false;
    for (uint word = 0u; word < params.maskWords; ++word) {
        uint left = masks[(p.tile * 2u) * params.maskWords + word];
        Counts counts = first;
        if (kManyLights != 0u && word > 0u) counts = countsOf(block, word);
        while (left != 0u) {
            uint bit = uint(findLSB(left));
            left &= left - 1u;
            vec4 shares = sharesSeen(counts, bit);
            bvec4 traced = notEqual((counts.traced >> bit) & 1u, uvec4(0u));
            doubt = doubt || inDoubt(shares, same) || any(greaterThan(uvec4(same), uvec4(traced)));
            addLight(p, word * 32u + bit, dot(weights, shares));
        }
    }
    return total >= kLeastWeight && !doubt;
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
                for (int i = 0; i < 4; ++i) weights[i] *= sameSurface(p.position, p.normal, places[i], spacing);
                if (!shade(p, block, counts, weights))
                    list[atomicAdd(listed, 1u)] = uint(pixel.x) | (uint(pixel.y) << 16);
            }
            storePixel(pixel, p.irradiance, p.specular);
        }
}
