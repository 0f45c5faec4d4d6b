// Turns the number of paths to trace into the workgroups of an indirect dispatch.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/photon.h"

layout(local_size_x = 1) in;
layout(set = 0, binding = SLOT_COUNTERS, std430) readonly buffer Counters { FrameCounters counters; };
layout(set = 0, binding = SLOT_CHOSEN_GROUPS, std430) writeonly buffer Groups { uint groups[]; };

void main() {
    groups[0] = (counters.pathsRetraced + TRACE_THREADS - 1u) / TRACE_THREADS;
    groups[1] = 1u;
    groups[2] = 1u;
}
