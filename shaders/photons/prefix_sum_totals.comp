// Turns the blocks' totals into the sums before each block, in place; the grand total goes behind them. One workgroup.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/saturating.glsl"
#include "shared/photon.h"

layout(local_size_x = 64) in;  // SCAN_THREADS
layout(push_constant) uniform Push { uint blockCount; };
layout(set = 0, binding = SLOT_SCAN_BLOCKS, std430) buffer Blocks { uint blocks[]; };

shared uint sums[SCAN_THREADS];

void main() {
    uint thread = gl_LocalInvocationIndex;
    uint share = (blockCount + SCAN_THREADS - 1u) / SCAN_THREADS;
    uint first = min(thread * share, blockCount), last = min(first + share, blockCount);
    uint sum = 0u;
    for (uint i = first; i < last; ++i) sum = saturatingAdd(sum, blocks[i]);
    sums[thread] = sum;
    barrier();
    if (thread == 0u) {
        uint running = 0u;
        for (uint t = 0u; t < SCAN_THREADS; ++t) {
            uint own = sums[t];
            sums[t] = running;
            running = saturatingAdd(running, own);
        }
        blocks[blockCount] = running;
    }
    barrier();
    uint running = sums[thread];
    for (uint i = first; i < last; ++i) {
        uint own = blocks[i];
        blocks[i] = running;
        running = saturatingAdd(running, own);
    }
}
