// The irradiance grid: a hash table over cells of space, and by the way a surface faces in them.
#ifndef LAMPYRIS_SHARED_IRRADIANCE_GRID_H
#define LAMPYRIS_SHARED_IRRADIANCE_GRID_H
#include "shared/glsl_compat.h"

LAMPYRIS_SHARED_BEGIN

LAMPYRIS_SLOT(SLOT_GRID_PARAMS, 0u);         // GridParams
LAMPYRIS_SLOT(SLOT_GRID_TABLE, 1u);          // GRID_SLOT_WORDS a slot
LAMPYRIS_SLOT(SLOT_GRID_CELLS, 2u);          // GridCell[], those in use
LAMPYRIS_SLOT(SLOT_GRID_COUNTERS, 3u);       // FrameCounters
LAMPYRIS_SLOT(SLOT_GRID_GROUPS, 4u);         // indirect dispatches: of columns, of cells
LAMPYRIS_SLOT(SLOT_GRID_LOOK_UP, 9u);        // texels RGBA32Uint a slot: irradiance as float bits, fingerprint
LAMPYRIS_SLOT(SLOT_GRID_PHOTONS, 6u);        // texels RGBA32Uint, two a photon
LAMPYRIS_SLOT(SLOT_GRID_PHOTON_TOTAL, 7u);   // path offsets; the last is the photons' number
LAMPYRIS_SLOT(SLOT_GRID_PHOTON_SLOTS, 8u);   // where each photon went; slotMask + 1: nowhere

// A slot of the table: fingerprint of its cell (0: free), power r, g, b as 64-bit sums (low words, high words),
// and the surface's area. Whole numbers, so that the sums do not hang on their order.
LAMPYRIS_SLOT(GRID_SLOT_WORDS, 8u);
LAMPYRIS_SLOT(GRID_WORD_LOW, 1u);
LAMPYRIS_SLOT(GRID_WORD_HIGH, 4u);
LAMPYRIS_SLOT(GRID_WORD_AREA, 7u);
LAMPYRIS_SLOT(GRID_POWER_UNITS, 1048576u);   // of TraceParams.powerScale watts
LAMPYRIS_SLOT(GRID_AREA_UNITS, 65536u);      // of a column's cross-section
LAMPYRIS_SLOT(GRID_MOST_PROBES, 64u);        // slots that a cell may lie beyond its first

// A cell's face: dominant axis of the normal (2·axis, + 1 if negative), then:
LAMPYRIS_SLOT(GRID_FACE_BACK, 8u);           // the back side of its triangles
LAMPYRIS_SLOT(GRID_FACE_PART_SHIFT, 4u);     // 0: sees the cell's middle; else 1 + the axis of what stands between
LAMPYRIS_SLOT(GRID_FACE_BITS, 7u);

struct GridParams {
    vec4 offsetCell;      // a place p is in cell floor(p / w + xyz); w = a cell's edge, metres
    uint slotMask;        // slots − 1, a power of two
    uint cellCapacity;
    uint columns;         // rays through a cell that measure the surface in it
    uint seed;
    float powerScale;     // watts
    uint pathCount;       // insertion: of this batch
    uint photonCapacity;  // insertion: of the store
    uint pad0;
};

struct GridCell {
    uint x, y, z;         // as int
    uint faceSlot;        // face, then the slot from bit GRID_FACE_BITS on
};

LAMPYRIS_SHARED_END
#endif
