// Adds each photon's power to its cell.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/irradiance_grid.glsl"
#include "lib/photon.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = SLOT_GRID_PHOTONS) uniform usamplerBuffer photons;
layout(set = 0, binding = SLOT_GRID_PHOTON_TOTAL, std430) readonly buffer Offsets { uint pathOffsets[]; };
layout(set = 0, binding = SLOT_GRID_TABLE, std430) buffer Table { uint table[]; };
layout(set = 0, binding = SLOT_GRID_CELLS, std430) buffer Cells { GridCell cells[]; };
layout(set = 0, binding = SLOT_GRID_PHOTON_SLOTS, std430) writeonly buffer PhotonSlots { uint photonSlots[]; };
layout(set = 0, binding = SLOT_GRID_COUNTERS, std430) buffer Counters { FrameCounters counters; };

// The cell's slot, taken if it has none; or slotMask + 1 where the table is too full.
uint slotOf(Cell cell) {
    uvec2 key = hashCell(cell);
    for (uint probe = 0u; probe < GRID_MOST_PROBES; ++probe) {
        uint slot = (key.x + probe) & grid.slotMask;
        uint before = atomicCompSwap(table[slot * GRID_SLOT_WORDS], 0u, key.y);
        if (before == key.y) return slot;
        if (before != 0u) continue;
        uint place = atomicAdd(counters.cells, 1u);
        if (place >= grid.cellCapacity) break;
        cells[place] = GridCell(uint(cell.at.x), uint(cell.at.y), uint(cell.at.z), cell.face | (slot << GRID_FACE_BITS));
        return slot;
    }
    return grid.slotMask + 1u;
}

// 64 bits in two words: the sum is the same in any order, and does not wrap.
void addPower(uint word, float power) {
    uint amount = uint(min(power, 4000.0) * float(GRID_POWER_UNITS) + 0.5);
    uint before = atomicAdd(table[word + GRID_WORD_LOW], amount);
    if (before > 0xffffffffu - amount) atomicAdd(table[word + GRID_WORD_HIGH], 1u);
}

void main() {
    uint photon = gl_GlobalInvocationID.x;
    if (photon >= min(pathOffsets[grid.pathCount], grid.photonCapacity)) return;
    uvec4 a = texelFetch(photons, int(2u * photon));
    uvec4 b = texelFetch(photons, int(2u * photon + 1u));
    uint slot = slotOf(cellOf(photonPosition(a), photonNormal(b), photonDirection(b)));
    photonSlots[photon] = slot;
    if (slot > grid.slotMask) {
        atomicAdd(counters.cellsDropped, 1u);
        return;
    }
    vec3 power = photonPower(a, b);
    for (uint c = 0u; c < 3u; ++c) addPower(slot * GRID_SLOT_WORDS + c, power[c]);
}
