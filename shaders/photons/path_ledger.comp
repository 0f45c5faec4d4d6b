// Sums what the paths of a group booked, one account and channel a thread, in the order of the paths.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/photon.h"

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { StoreParams params; };
layout(set = 0, binding = SLOT_BOOKINGS, std430) readonly buffer Bookings { float bookings[]; };
layout(set = 0, binding = SLOT_LEDGER, std430) writeonly buffer Ledger { float ledger[]; };

void main() {
    uint group = gl_GlobalInvocationID.x / BOOKED;
    uint account = gl_GlobalInvocationID.x % BOOKED;
    uint first = group * TRACE_THREADS;
    if (first >= params.pathCount) return;
    uint end = min(first + TRACE_THREADS, params.pathCount);
    float sum = 0.0;
    for (uint path = first; path < end; ++path) sum += bookings[path * BOOKING_FLOATS + account];
    ledger[group * LEDGER_FLOATS + account] = sum;
}
