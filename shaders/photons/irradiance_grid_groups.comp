// Turns the number of cells into the workgroups of two indirect dispatches: over their columns, and over themselves.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/irradiance_grid.h"
#include "shared/photon.h"

layout(local_size_x = 1) in;
layout(set = 0, binding = SLOT_GRID_PARAMS, std140) uniform Grid { GridParams grid; };
layout(set = 0, binding = SLOT_GRID_COUNTERS, std430) readonly buffer Counters { FrameCounters counters; };
layout(set = 0, binding = SLOT_GRID_GROUPS, std430) writeonly buffer Groups { uint groups[]; };

// Rows of at most 65535 groups, Vulkan's guaranteed limit.
void writeGroups(uint at, uint threads) {
    uint needed = (threads + 63u) / 64u;
    uint rows = (needed + 65534u) / 65535u;
    groups[at] = rows > 0u ? (needed + rows - 1u) / rows : 0u;
    groups[at + 1u] = max(rows, 1u);
    groups[at + 2u] = 1u;
}

void main() {
    uint cells = min(counters.cells, grid.cellCapacity);
    writeGroups(0u, cells * grid.columns);
    writeGroups(3u, cells);
}
