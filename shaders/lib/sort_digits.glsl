// A stable radix sort of the pairs by tile, a digit at a time: each thread keeps its own run of pairs in order.
#ifndef LAMPYRIS_LIB_SORT_DIGITS
#define LAMPYRIS_LIB_SORT_DIGITS
#include "shared/photon.h"
#include "shared/tile_bin.h"

layout(push_constant) uniform Push { BinParams params; };
layout(set = 0, binding = SLOT_BIN_TILES, std430) readonly buffer Tiles { uint tiles[]; };
layout(set = 0, binding = SLOT_BIN_PHOTON_TOTAL, std430) readonly buffer PairTotal { uint pairOffsets[]; };

const uint kPairsPerThread = SORT_BLOCK / SORT_THREADS;
shared uint digitCounts[SORT_DIGITS * SORT_THREADS];

uint pairCount() { return min(pairOffsets[params.capacity], params.pairCapacity); }
uint digitOf(uint tile) { return (tile >> params.shift) & (SORT_DIGITS - 1u); }

// Fills digitCounts[digit · threads + thread].
void countDigits(uint thread, uint first, uint last) {
    for (uint digit = 0u; digit < SORT_DIGITS; ++digit) digitCounts[digit * SORT_THREADS + thread] = 0u;
    for (uint i = first; i < last; ++i) ++digitCounts[digitOf(tiles[i]) * SORT_THREADS + thread];
    barrier();
}

#endif
