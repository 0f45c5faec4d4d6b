// Lists the pixels whose low-resolution neighbours do not stand for them: other normal, other place, or none.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/coarse_block.glsl"
#include "lib/surface.glsl"
#include "shared/photon.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = SLOT_GATHER_LIST, std430) writeonly buffer List { uint list[]; };
layout(set = 0, binding = SLOT_GATHER_COUNTERS, std430) buffer Counters { FrameCounters counters; };

// The surfaces at a block's four texels, in view space; w = 1 where there is one.
vec4 places[4];
vec3 normals[4];

bool standsApart(vec4 weights, ivec2 pixel, float depth) {
    vec4 place = vec4(0.0);
    vec3 normal = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        place += weights[i] * places[i];
        normal += weights[i] * normals[i];
    }
    // In units of a low-resolution texel's width at this depth [Thesis listing 5.18 left the unit open].
    vec3 position = positionView(pixel, depth);
    float texel = pixelFootprint(-position.z) * float(params.divisor);
    vec3 own = unpackOctahedral(texelFetch(surfaceNormal, pixel, 0).r);
    float turned = dot(own, normal);
    vec3 away = position - place.xyz;
    return place.w < 0.9999 || turned < 0.0 || turned * turned < params.normalLimit * params.normalLimit * dot(own, own) ||
           dot(away, away) > texel * texel;
}

void main() {
    ivec2 block = ivec2(gl_GlobalInvocationID.xy);
    ivec2 first = firstPixel(block);
    if (any(greaterThanEqual(first, ivec2(view.width, view.height)))) return;
    for (int i = 0; i < 4; ++i) {
        ivec2 at = representative(texelOf(block, i));
        float depth = depthAt(at);
        places[i] = depth > 0.0 ? vec4(positionView(at, depth), 1.0) : vec4(0.0);
        normals[i] = normalAt(at);
    }
    int divisor = int(params.divisor);
    vec2 span = blockSpan(block);
    for (int y = 0; y < divisor; ++y)
        for (int x = y == 0 ? 1 : 0; x < divisor; ++x) {  // the first pixel is a representative itself
            ivec2 pixel = first + ivec2(x, y);
            if (!inImage(pixel)) continue;
            float depth = depthAt(pixel);
            if (depth <= 0.0 || !standsApart(texelWeights(ivec2(x, y), span), pixel, depth)) continue;
            list[atomicAdd(counters.pixelsRecomputed, 1u)] = uint(pixel.x) | (uint(pixel.y) << 16);
        }
}
