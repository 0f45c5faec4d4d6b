// Exclusive sums inside blocks of SCAN_BLOCK counts, and each block's total.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/saturating.glsl"
#include "shared/photon.h"

layout(local_size_x = 64) in;  // SCAN_THREADS
layout(push_constant) uniform Push { uint count; };
layout(set = 0, binding = SLOT_SCAN_COUNTS, std430) readonly buffer Counts { uint counts[]; };
layout(set = 0, binding = SLOT_SCAN_OFFSETS, std430) writeonly buffer Offsets { uint offsets[]; };
layout(set = 0, binding = SLOT_SCAN_BLOCKS, std430) writeonly buffer Blocks { uint blocks[]; };

const uint kPerThread = SCAN_BLOCK / SCAN_THREADS;
shared uint sums[SCAN_THREADS];

void main() {
    uint thread = gl_LocalInvocationIndex;
    uint first = gl_WorkGroupID.x * SCAN_BLOCK + thread * kPerThread;
    uint sum = 0u;
    for (uint i = first; i < min(first + kPerThread, count); ++i) sum = saturatingAdd(sum, counts[i]);
    sums[thread] = sum;
    barrier();
    if (thread == 0u) {
        uint running = 0u;
        for (uint t = 0u; t < SCAN_THREADS; ++t) {
            uint own = sums[t];
            sums[t] = running;
            running = saturatingAdd(running, own);
        }
        blocks[gl_WorkGroupID.x] = running;
    }
    barrier();
    uint running = sums[thread];
    for (uint i = first; i < min(first + kPerThread, count); ++i) {
        offsets[i] = running;
        running = saturatingAdd(running, counts[i]);
    }
}
