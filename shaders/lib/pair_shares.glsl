// How many (tile, photon) pairs there are.
#ifndef LAMPYRIS_LIB_PAIR_SHARES
#define LAMPYRIS_LIB_PAIR_SHARES
#include "shared/tile_bin.h"

layout(push_constant) uniform Push { BinParams params; };
layout(set = 0, binding = SLOT_BIN_PAIR_TOTAL, std430) readonly buffer PairTotal { uint pairOffsets[]; };

uint pairsWanted() { return pairOffsets[params.capacity * params.bands]; }
uint pairCount() { return min(pairsWanted(), params.pairCapacity); }

#endif
