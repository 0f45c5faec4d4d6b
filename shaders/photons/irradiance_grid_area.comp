// How much surface a cell has: a column of the cell a thread, along the dominant axis of its face. Every surface that
// the column crosses and that belongs to the cell counts with its cross-section over the cosine.                  [I3]
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/indirect_groups.glsl"
#include "lib/irradiance_grid.glsl"
#include "shared/photon.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = SLOT_GRID_TABLE, std430) buffer Table { uint table[]; };
layout(set = 0, binding = SLOT_GRID_CELLS, std430) readonly buffer Cells { GridCell cells[]; };
layout(set = 0, binding = SLOT_GRID_COUNTERS, std430) readonly buffer Counters { FrameCounters counters; };

// [chosen] Layers of surface within one cell; more are left out, and the cell is brighter for it.
const uint kMostLayers = 8u;

// The share of the column's cross-section, over the cosine, of the surfaces that are the cell's.
float columnArea(Cell cell, uint column) {
    // By the cell, not by its slot, which hangs on who came first.
    vec2 shift = vec2(tea(uvec2(hashCell(cell).y, grid.seed), 8) & 0x00FFFFFFu) * kTwoToMinus24;
    vec2 xi = fract(hammersley(column, grid.columns) + shift) - 0.5;
    uint axisNumber = (cell.face & 7u) >> 1;
    vec3 axis = axisVector(axisNumber);
    vec3 outward = (cell.face & 1u) != 0u ? -axis : axis;
    vec3 origin = cellMiddle(cell.at) + grid.offsetCell.w * (xi.x * axis.yzx + xi.y * axis.zxy + 0.5 * outward);
    float area = 0.0, reached = 0.0;
    for (uint layer = 0u; layer < kMostLayers; ++layer) {
        Hit hit;
        if (!traceClosest(origin, -outward, reached, grid.offsetCell.w, hit)) break;
        reached = hit.t;
        vec3 normal = storedNormal(hit.normalWorld);
        uint side = sideOf(normal, -outward);
        if (side != (cell.face & kSideMask)) continue;
        vec3 facing = (side & GRID_FACE_BACK) != 0u ? -normal : normal;
        uint part = cellPart(cell.at, origin - outward * hit.t, facing, axis);
        if (part == cell.face >> GRID_FACE_PART_SHIFT) area += 1.0 / abs(dot(axis, normal));
    }
    return area;
}

void main() {
    uint thread = threadInRows();
    uint place = thread / grid.columns;
    if (place >= min(counters.cells, grid.cellCapacity)) return;
    GridCell record = cells[place];
    Cell cell = Cell(ivec3(record.x, record.y, record.z), record.faceSlot & ((1u << GRID_FACE_BITS) - 1u));
    uint slot = record.faceSlot >> GRID_FACE_BITS;
    float area = columnArea(cell, thread % grid.columns);
    atomicAdd(table[slot * GRID_SLOT_WORDS + GRID_WORD_AREA], uint(area * float(GRID_AREA_UNITS) + 0.5));
}
