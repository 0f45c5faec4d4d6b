// Indirect dispatches of one thread an element, 64 a group, in rows of at most 65535 groups: Vulkan's guaranteed limit.
#ifndef LAMPYRIS_LIB_INDIRECT_GROUPS
#define LAMPYRIS_LIB_INDIRECT_GROUPS

uvec3 groupsFor(uint threads) {
    uint needed = (threads + 63u) / 64u;
    uint rows = (needed + 65534u) / 65535u;
    return uvec3(rows > 0u ? (needed + rows - 1u) / rows : 0u, max(rows, 1u), 1u);
}

// This thread's element; past the last one the thread has none.
uint threadInRows() { return gl_GlobalInvocationID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x; }

#endif
