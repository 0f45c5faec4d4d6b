// Turns the number of pixels to recompute into the workgroups of an indirect dispatch.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/photon.h"
#include "shared/tile_bin.h"

layout(local_size_x = 1) in;
layout(set = 0, binding = SLOT_GATHER_COUNTERS, std430) readonly buffer Counters { FrameCounters counters; };
layout(set = 0, binding = SLOT_GATHER_GROUPS, std430) writeonly buffer Groups { uint groups[]; };

// Rows of at most 65535 groups, Vulkan's guaranteed limit.
void main() {
    uint needed = (counters.pixelsRecomputed + 63u) / 64u;
    uint rows = (needed + 65534u) / 65535u;
    groups[0] = rows > 0u ? (needed + rows - 1u) / rows : 0u;
    groups[1] = max(rows, 1u);
    groups[2] = 1u;
}
