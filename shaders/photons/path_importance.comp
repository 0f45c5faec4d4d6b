// What each path came to matter: the variance that its photons bring to the cells which the picture looked up.    [P5]
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/cell_area.glsl"
#include "lib/photon.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = SLOT_IMPORTANCE_PARAMS, std140) uniform Grid { GridParams grid; };
layout(set = 0, binding = SLOT_IMPORTANCE_PHOTONS) uniform usamplerBuffer photons;
layout(set = 0, binding = SLOT_IMPORTANCE_OFFSETS, std430) readonly buffer Offsets { uint pathOffsets[]; };
layout(set = 0, binding = SLOT_IMPORTANCE_SLOTS, std430) readonly buffer Slots { uint photonSlots[]; };
layout(set = 0, binding = SLOT_IMPORTANCE_TABLE, std430) readonly buffer Table { uint table[]; };
layout(set = 0, binding = SLOT_IMPORTANCE_LOOK_UPS, std430) readonly buffer LookUps { uint lookUps[]; };
layout(set = 0, binding = SLOT_IMPORTANCE, std430) writeonly buffer Importance { float importance[]; };

void main() {
    uint path = gl_GlobalInvocationID.x;
    if (path >= grid.pathCount) return;
    uint end = min(pathOffsets[path + 1u], grid.photonCapacity);
    float sum = 0.0;
    for (uint photon = pathOffsets[path]; photon < end; ++photon) {
        uint slot = photonSlots[photon];
        if (slot > grid.slotMask) continue;
        vec3 power = photonPower(texelFetch(photons, int(2u * photon)), texelFetch(photons, int(2u * photon + 1u)));
        float metres2 = cellMetres2(grid, table[slot * GRID_SLOT_WORDS + GRID_WORD_AREA]);
        float irradiance = dot(power, vec3(1.0 / 3.0)) / metres2;
        sum += float(lookUps[slot]) * irradiance * irradiance;
    }
    importance[path] = sum;
}
