// Turns the number of pixels that trace their own shadow rays into the workgroups of an indirect dispatch.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/indirect_groups.glsl"
#include "shared/direct.h"

layout(local_size_x = 1) in;
layout(set = 0, binding = SLOT_SHADOW_LISTED, std430) readonly buffer Listed { uint listed; };
layout(set = 0, binding = SLOT_SHADOW_GROUPS, std430) writeonly buffer Groups { uint groups[]; };

void main() {
    uvec3 needed = groupsFor(listed);
    for (int i = 0; i < 3; ++i) groups[i] = needed[i];
}
