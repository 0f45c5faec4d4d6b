// The jobs of the refit nodes, and boxes in cells as modules/accel/tree.h has them, bit for bit.
#ifndef LAMPYRIS_LIB_REFIT
#define LAMPYRIS_LIB_REFIT
#include "shared/bvh.h"
#include "shared/refit.h"

layout(set = 0, binding = SLOT_REFIT_JOBS, std430) readonly buffer Jobs { GpuRefitJob jobs[]; };
layout(set = 0, binding = SLOT_REFIT_NODES) uniform usamplerBuffer nodes;
layout(push_constant) uniform Push { RefitPush push; };

// Dispatches are wide before they are high: a device may limit both.
uint refitGroup() { return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; }

// The last job that begins at this workgroup or before; the same for all of its invocations.
uint refitJob() {
    uint first = 0u;
    for (uint left = push.jobs; left > 1u;) {
        uint middle = left / 2u;
        if (jobs[first + middle].firstGroup <= refitGroup()) first += middle;
        left -= middle;
    }
    return first;
}

uint refitIndex(uint job) {
    return (refitGroup() - jobs[job].firstGroup) * REFIT_THREADS + gl_LocalInvocationIndex;
}

const uvec3 kNoBox = uvec3(0xffffffffu);

uvec3 toCells(vec3 lower, vec3 upper, vec3 offset, vec3 cellsPerMetre) {
    precise vec3 from = (lower - offset) * cellsPerMetre;
    precise vec3 to = (upper - offset) * cellsPerMetre;
    uvec3 low = uvec3(clamp(from, vec3(1.0), vec3(65535.0))) - 1u;
    uvec3 high = uvec3(clamp(to, vec3(0.0), vec3(65533.0))) + 2u;
    return low | (high << 16);
}

uvec3 unitedCells(uvec3 a, uvec3 b) {
    uvec3 both = min(a & 0xffffu, b & 0xffffu) | (max(a >> 16, b >> 16) << 16);
    return a.x == kNoBox.x ? b : (b.x == kNoBox.x ? a : both);
}

#endif
