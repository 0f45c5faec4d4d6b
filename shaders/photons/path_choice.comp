// Which paths are traced again: those whose emitter changed, whose turn it is, or a segment of which meets a box in
// which geometry changed. A path that a change touches keeps its random numbers: were it drawn anew, paths that go where
// things move would leave the store and only a few return. The list's order varies; each path has its own place.  [K1]
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/path_range.glsl"

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { ChoiceParams params; };
layout(set = 0, binding = SLOT_CHOICE_VERTICES, std430) readonly buffer Vertices { vec4 vertices[]; };
layout(set = 0, binding = SLOT_CHOICE_BOXES, std430) readonly buffer Boxes { vec4 corners[]; };
layout(set = 0, binding = SLOT_CHOICE_AGAIN, std430) readonly buffer Again { uint rangeAgain[]; };
layout(set = 0, binding = SLOT_CHOSEN_PATHS, std430) writeonly buffer Chosen { uint chosen[]; };
layout(set = 0, binding = SLOT_COUNTERS, std430) buffer Counters { FrameCounters counters; };

bool meetsBox(vec3 from, vec3 to) {
    vec3 way = to - from;
    vec3 inverse = 1.0 / mix(way, vec3(1e-20), lessThan(abs(way), vec3(1e-20)));
    bool meets = false;
    for (uint i = 0u; i < params.boxCount; ++i) {
        vec3 a = (corners[2u * i].xyz - from) * inverse;
        vec3 b = (corners[2u * i + 1u].xyz - from) * inverse;
        vec3 near = min(a, b), far = max(a, b);
        meets = meets || max(max(near.x, near.y), max(near.z, 0.0)) <= min(min(far.x, far.y), min(far.z, 1.0));
    }
    return meets;
}

void main() {
    uint path = gl_GlobalInvocationID.x;
    if (path >= params.pathCount) return;
    bool anew = params.all != 0u || (params.turns > 0u && path % params.turns == params.turn);
    bool again = anew || rangeAgain[rangeIndexOf(path, params.rangeCount)] != 0u;
    if (!again && params.boxCount > 0u) {
        uint first = path * params.verticesPerPath;
        uint count = floatBitsToUint(vertices[first].w);
        for (uint i = 1u; i < count && !again; ++i) again = meetsBox(vertices[first + i - 1u].xyz, vertices[first + i].xyz);
    }
    if (again) chosen[atomicAdd(counters.pathsRetraced, 1u)] = path | (anew ? CHOSEN_ANEW : 0u);
}
