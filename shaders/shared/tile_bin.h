// Slots and parameters of binning photons to tiles, gathering from them, up-sampling and compositing.
#ifndef LAMPYRIS_SHARED_TILE_BIN_H
#define LAMPYRIS_SHARED_TILE_BIN_H
#include "shared/glsl_compat.h"

LAMPYRIS_SHARED_BEGIN

LAMPYRIS_SLOT(SLOT_BIN_PHOTONS, 0u);        // texels RGBA32Uint, two a photon
LAMPYRIS_SLOT(SLOT_BIN_BOUNDS, 1u);         // texels RG32Float, one a tile
LAMPYRIS_SLOT(SLOT_BIN_COUNTERS, 2u);       // FrameCounters
LAMPYRIS_SLOT(SLOT_BIN_COUNTS, 3u);         // pairs a photon and band, or a tile
LAMPYRIS_SLOT(SLOT_BIN_OFFSETS, 4u);        // sums before each of those
LAMPYRIS_SLOT(SLOT_BIN_PAIRS, 5u);          // uvec2: tile, photon; photon by photon
LAMPYRIS_SLOT(SLOT_BIN_INDICES, 6u);        // photons, tile by tile
LAMPYRIS_SLOT(SLOT_BIN_SHARES, 7u);         // [share][tile]: pairs, then the sum over the shares before
LAMPYRIS_SLOT(SLOT_BIN_RANGES, 9u);         // uvec2 a tile: first place in the list, pairs
LAMPYRIS_SLOT(SLOT_BIN_PAIR_TOTAL, 13u);    // sums before each photon and band; the last is the pairs' number
LAMPYRIS_SLOT(SLOT_BIN_PHOTON_TOTAL, 14u);  // path offsets; the last is the photons' number

LAMPYRIS_SLOT(SLOT_GATHER_INDICES, 2u);     // texels R32Uint
LAMPYRIS_SLOT(SLOT_GATHER_COUNTERS, 1u);    // FrameCounters
LAMPYRIS_SLOT(SLOT_GATHER_COARSE, 3u);      // irradiance at low resolution
LAMPYRIS_SLOT(SLOT_GATHER_EDGES, 4u);       // image that shows the listed pixels
LAMPYRIS_SLOT(SLOT_GATHER_LIST, 5u);        // pixels to recompute, x | y << 16
LAMPYRIS_SLOT(SLOT_GATHER_ESTIMATES, 6u);   // vec4 of irradiance for each of them
LAMPYRIS_SLOT(SLOT_GATHER_IRRADIANCE, 7u);  // at full resolution
LAMPYRIS_SLOT(SLOT_GATHER_GROUPS, 8u);      // indirect dispatch

// Final gather; the irradiance grid takes slots 0 and 9.
LAMPYRIS_SLOT(SLOT_FINAL_COARSE, 2u);       // irradiance at low resolution, as it comes out
LAMPYRIS_SLOT(SLOT_FINAL_GUIDE, 3u);        // where each texel stands: position as float bits, normal octahedral
LAMPYRIS_SLOT(SLOT_FINAL_COARSE_IN, 4u);    // … as it is read
LAMPYRIS_SLOT(SLOT_FINAL_GUIDE_IN, 6u);
LAMPYRIS_SLOT(SLOT_FINAL_JOINED, 4u);       // irradiance at full resolution; alpha 0 where a pixel traced its own rays
LAMPYRIS_SLOT(SLOT_FINAL_LOOK_UPS, 5u);     // how often each slot of the grid was looked up by a texel's first ray

LAMPYRIS_SLOT(SLOT_COMPOSITE_DIRECT, 0u);
LAMPYRIS_SLOT(SLOT_COMPOSITE_SPECULAR, 1u);
LAMPYRIS_SLOT(SLOT_COMPOSITE_INDIRECT, 2u);
LAMPYRIS_SLOT(SLOT_COMPOSITE_MASKS, 3u);
LAMPYRIS_SLOT(SLOT_COMPOSITE_OUT, 4u);

LAMPYRIS_SLOT(TILE_CHUNKS, 8u);             // shares of the photon list that a tile's 64 threads take, 8 threads each

struct BinParams {
    uint capacity;       // photons (store) that may be there
    uint pathCount;      // of this batch: where the photons' total stands in the path offsets
    uint pairCapacity;
    float radius;        // metres
    uint share;          // pairs a share
    uint bandRows;       // rows of tiles that one thread visits
    uint bands;
    uint pad0;
};

struct GatherParams {
    float radius;        // metres
    float powerScale;    // watts
    uint divisor;        // an axis
    uint coarseWidth;
    uint coarseHeight;
    uint lightCount;     // composite
    uint maskWords;
    float normalLimit;   // least cosine between a pixel's normal and its neighbours'
    uint rays;           // final gather: a texel
    uint seed;
    uint step;           // filter: texels between two taps
    uint emitterCount;   // final gather: emissive instances
    uint turn;           // final gather: the frame's number; 0 where frames are all alike
    uint pad0, pad1, pad2;
};

LAMPYRIS_SHARED_END
#endif
