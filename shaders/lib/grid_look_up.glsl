// The irradiance that the grid has for a cell, and the cell's slot: W/m²; 0 and slotMask + 1 where no photon fell.
#ifndef LAMPYRIS_LIB_GRID_LOOK_UP
#define LAMPYRIS_LIB_GRID_LOOK_UP
#include "lib/irradiance_grid.glsl"

layout(set = 0, binding = SLOT_GRID_LOOK_UP) uniform usamplerBuffer gridLookUp;

vec3 gridIrradiance(Cell cell, out uint slot) {
    uvec2 key = hashCell(cell);
    for (uint probe = 0u; probe < GRID_MOST_PROBES; ++probe) {
        slot = (key.x + probe) & grid.slotMask;
        uvec4 found = texelFetch(gridLookUp, int(slot));
        if (found.w == key.y) return uintBitsToFloat(found.xyz);
        if (found.w == 0u) break;
    }
    slot = grid.slotMask + 1u;
    return vec3(0.0);
}

#endif
