// full, sort: how often each digit stands in each block; digit-major, so that a prefix sum gives the places.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/sort_digits.glsl"

layout(local_size_x = 64) in;  // SORT_THREADS
layout(set = 0, binding = SLOT_BIN_COUNTS, std430) writeonly buffer Counts { uint counts[]; };

void main() {
    uint thread = gl_LocalInvocationIndex;
    uint total = pairCount();
    uint first = min(gl_WorkGroupID.x * SORT_BLOCK + thread * kPairsPerThread, total);
    countDigits(thread, first, min(first + kPairsPerThread, total));
    if (thread < SORT_DIGITS) {
        uint sum = 0u;
        for (uint t = 0u; t < SORT_THREADS; ++t) sum += digitCounts[thread * SORT_THREADS + t];
        counts[thread * params.blocks + gl_WorkGroupID.x] = sum;
    }
}
