// Lists the pixels whose four low-resolution neighbours do not stand for them: other normal, other place, or none.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/coarse_taps.glsl"
#include "shared/photon.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = SLOT_GATHER_EDGES, r32ui) uniform writeonly uimage2D edges;
layout(set = 0, binding = SLOT_GATHER_LIST, std430) writeonly buffer List { uint list[]; };
layout(set = 0, binding = SLOT_GATHER_COUNTERS, std430) buffer Counters { FrameCounters counters; };

bool standsApart(ivec2 pixel, float depth) {
    vec3 position = positionWorld(pixel, depth);
    vec3 normal = normalAt(pixel);
    CoarseTaps taps = coarseTaps(pixel);
    vec3 meanNormal = vec3(0.0), meanPosition = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 at = representative(taps.texels[i]);
        float tapDepth = depthAt(at);
        if (tapDepth <= 0.0) return true;
        meanNormal += taps.weights[i] * normalAt(at);
        meanPosition += taps.weights[i] * positionWorld(at, tapDepth);
    }
    // In units of a low-resolution texel's width at this depth [Thesis listing 5.18 left the unit open].
    float texel = pixelFootprint(viewDepth(depth)) * float(params.divisor);
    return dot(normal, meanNormal) < params.normalLimit || distance(position, meanPosition) > texel;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (!insideImage(pixel)) return;
    float depth = depthAt(pixel);
    uint place = 0u;
    if (depth > 0.0 && params.divisor > 1u && standsApart(pixel, depth)) {
        place = atomicAdd(counters.pixelsRecomputed, 1u) + 1u;
        list[place - 1u] = uint(pixel.x) | (uint(pixel.y) << 16);
    }
    imageStore(edges, pixel, uvec4(place));
}
