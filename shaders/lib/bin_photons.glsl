// What the kernels of tile binning share: how many photons there are, and where one lies in view space.
#ifndef LAMPYRIS_LIB_BIN_PHOTONS
#define LAMPYRIS_LIB_BIN_PHOTONS
#include "lib/tile.glsl"
#include "shared/photon.h"
#include "shared/tile_bin.h"

layout(push_constant) uniform Push { BinParams params; };
layout(set = 0, binding = SLOT_BIN_PHOTONS) uniform usamplerBuffer binPhotons;
layout(set = 0, binding = SLOT_BIN_PHOTON_TOTAL, std430) readonly buffer PhotonTotal { uint pathOffsets[]; };

uint photonCount() { return min(pathOffsets[params.pathCount], params.capacity); }
vec3 photonViewDepth(uint photon) {
    return toViewDepth(uintBitsToFloat(texelFetch(binPhotons, int(photon * 2u)).xyz));
}

#endif
