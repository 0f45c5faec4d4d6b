// Irradiance of each cell in use: power over area.                                                               [I2]
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/cell_area.glsl"
#include "lib/indirect_groups.glsl"
#include "shared/photon.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = SLOT_GRID_PARAMS, std140) uniform Grid { GridParams grid; };
layout(set = 0, binding = SLOT_GRID_TABLE, std430) readonly buffer Table { uint table[]; };
layout(set = 0, binding = SLOT_GRID_CELLS, std430) readonly buffer Cells { GridCell cells[]; };
layout(set = 0, binding = SLOT_GRID_COUNTERS, std430) readonly buffer Counters { FrameCounters counters; };
layout(set = 0, binding = SLOT_GRID_LOOK_UP, std430) buffer LookUp { uvec4 lookUp[]; };

void main() {
    uint place = threadInRows();
    if (place >= min(counters.cells, grid.cellCapacity)) return;
    uint slot = cells[place].faceSlot >> GRID_FACE_BITS;
    uint word = slot * GRID_SLOT_WORDS;
    vec3 power;
    for (uint c = 0u; c < 3u; ++c)
        power[c] = (float(table[word + GRID_WORD_LOW + c]) + 4294967296.0 * float(table[word + GRID_WORD_HIGH + c])) /
                   float(GRID_POWER_UNITS);
    float metres2 = cellMetres2(grid, table[word + GRID_WORD_AREA]);
    lookUp[slot] = uvec4(floatBitsToUint(power * grid.powerScale / metres2), table[word]);
}
