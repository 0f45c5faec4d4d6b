// Turns the number of cells into the workgroups of two indirect dispatches: over their columns, and over themselves.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/indirect_groups.glsl"
#include "shared/irradiance_grid.h"
#include "shared/photon.h"

layout(local_size_x = 1) in;
layout(set = 0, binding = SLOT_GRID_PARAMS, std140) uniform Grid { GridParams grid; };
layout(set = 0, binding = SLOT_GRID_COUNTERS, std430) readonly buffer Counters { FrameCounters counters; };
layout(set = 0, binding = SLOT_GRID_GROUPS, std430) writeonly buffer Groups { uint groups[]; };

void main() {
    uint cells = min(counters.cells, grid.cellCapacity);
    uvec3 ofColumns = groupsFor(cells * grid.columns), ofCells = groupsFor(cells);
    for (int i = 0; i < 3; ++i) {
        groups[i] = ofColumns[i];
        groups[3 + i] = ofCells[i];
    }
}
