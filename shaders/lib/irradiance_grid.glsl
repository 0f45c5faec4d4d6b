// Which cell of the irradiance grid a point of a surface belongs to, and what light the cell has.      [I1], [I2]
// A cell is told apart by place, by the dominant axis of the side that is lit, by front and back, and by its part:
// what a wall within the cell parts from its middle is another cell, so that light does not leak along floors.
#ifndef LAMPYRIS_LIB_IRRADIANCE_GRID
#define LAMPYRIS_LIB_IRRADIANCE_GRID
#include "lib/bvh_walk.glsl"
#include "lib/pack.glsl"
#include "lib/rng.glsl"
#include "shared/irradiance_grid.h"

layout(set = 0, binding = SLOT_GRID_PARAMS, std140) uniform Grid { GridParams grid; };

struct Cell {
    ivec3 at;
    uint face;
};

ivec3 cellAt(vec3 position) { return ivec3(floor(position / grid.offsetCell.w + grid.offsetCell.xyz)); }
vec3 cellMiddle(ivec3 at) { return (vec3(at) + 0.5 - grid.offsetCell.xyz) * grid.offsetCell.w; }

vec3 axisVector(uint axis) { return vec3(axis == 0u, axis == 1u, axis == 2u); }

// 2·axis, + 1 where the normal points the negative way. The weights keep normals between two axes, as of walls at
// 45 degrees, from being torn apart by rounding.
uint dominantAxis(vec3 normal) {
    vec3 a = abs(normal) * vec3(1.0, 1.019, 0.983);
    uint axis = a.x >= a.y ? (a.x >= a.z ? 0u : 2u) : (a.y >= a.z ? 1u : 2u);
    return 2u * axis + (dot(axisVector(axis), normal) < 0.0 ? 1u : 0u);
}

// The normal as photons keep it.
vec3 storedNormal(vec3 normal) { return unpackDirection(packDirection(normal)); }

// 0 where the cell's middle can be seen along the surface; else 1 + the dominant axis of what stands between.
uint cellPart(ivec3 at, vec3 position, vec3 normal, vec3 axis) {
    vec3 to = cellMiddle(at) - position;
    to -= axis * dot(to, axis);
    to -= axis * (dot(to, normal) / dot(axis, normal));  // along the tangent plane
    // [chosen] Clear of what lies on the surface, under most things that part it.
    vec3 origin = position + normal * (0.05 * grid.offsetCell.w);
    Hit hit;
    if (!traceClosest(origin, to, 0.0, 1.0, hit)) return 0u;
    return 1u + dominantAxis(dot(hit.normalWorld, to) > 0.0 ? -hit.normalWorld : hit.normalWorld);
}

const uint kSideMask = (1u << GRID_FACE_PART_SHIFT) - 1u;

// A face but for its part.
uint sideOf(vec3 frontNormal, vec3 travel) {
    bool back = dot(frontNormal, travel) > 0.0;
    return dominantAxis(back ? -frontNormal : frontNormal) | (back ? GRID_FACE_BACK : 0u);
}

// The cell of a surface that something met which travelled that way. frontNormal as storedNormal() gives it.
Cell cellOf(vec3 position, vec3 frontNormal, vec3 travel) {
    uint side = sideOf(frontNormal, travel);
    vec3 normal = (side & GRID_FACE_BACK) != 0u ? -frontNormal : frontNormal;
    ivec3 at = cellAt(position);
    uint part = cellPart(at, position, normal, axisVector((side & 7u) >> 1));
    return Cell(at, side | (part << GRID_FACE_PART_SHIFT));
}

// First slot and fingerprint. Cells wrap after 2^18 an axis; the pairs are a bijection of what is left.
uvec2 hashCell(Cell cell) {
    uvec3 u = uvec3(cell.at) & 0x3ffffu;
    uvec2 mixed = tea(uvec2(u.x | (u.y << 18), (u.y >> 14) | (u.z << 4) | (cell.face << 22)), 8);
    return uvec2(mixed.x & grid.slotMask, max(mixed.y, 1u));
}

#endif
