// Moves the staged photons of each path to their place in the store: order (path, bounce), no gaps.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/photon.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { StoreParams params; };
layout(set = 0, binding = SLOT_STAGED_PHOTONS, std430) readonly buffer Staged { PackedPhoton staged[]; };
layout(set = 0, binding = SLOT_PATH_OFFSETS, std430) readonly buffer Offsets { uint pathOffsets[]; };
layout(set = 0, binding = SLOT_PHOTONS, std430) writeonly buffer Photons { PackedPhoton photons[]; };
layout(set = 0, binding = SLOT_COUNTERS, std430) buffer Counters { FrameCounters counters; };

void main() {
    uint path = gl_GlobalInvocationID.x;
    if (path >= params.pathCount) return;
    uint first = pathOffsets[path];
    uint count = pathOffsets[path + 1u] - first;
    for (uint i = 0u; i < count && first + i < params.capacity; ++i)
        photons[first + i] = staged[path * params.photonsPerPath + i];
    if (path == 0u) {
        uint total = pathOffsets[params.pathCount];
        atomicAdd(counters.photonsStored, min(total, params.capacity));
        atomicAdd(counters.photonsDropped, total - min(total, params.capacity));
        atomicMax(counters.photonsNeeded, total);
    }
}
