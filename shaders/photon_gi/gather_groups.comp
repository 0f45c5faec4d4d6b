// Turns the number of pixels to recompute into the workgroups of an indirect dispatch.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/indirect_groups.glsl"
#include "shared/photon.h"
#include "shared/tile_bin.h"

layout(local_size_x = 1) in;
layout(set = 0, binding = SLOT_GATHER_COUNTERS, std430) readonly buffer Counters { FrameCounters counters; };
layout(set = 0, binding = SLOT_GATHER_GROUPS, std430) writeonly buffer Groups { uint groups[]; };

void main() {
    uvec3 needed = groupsFor(counters.pixelsRecomputed);
    for (int i = 0; i < 3; ++i) groups[i] = needed[i];
}
