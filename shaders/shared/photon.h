// Photons, the split of paths over emitters, the energy ledger, and the counters of a frame.
#ifndef LAMPYRIS_SHARED_PHOTON_H
#define LAMPYRIS_SHARED_PHOTON_H
#include "shared/glsl_compat.h"

LAMPYRIS_SHARED_BEGIN

// photon_trace
LAMPYRIS_SLOT(SLOT_PATH_RANGES, 0u);      // PathRange[]
LAMPYRIS_SLOT(SLOT_STAGED_PHOTONS, 1u);   // PackedPhoton[], a fixed number a path
LAMPYRIS_SLOT(SLOT_PATH_COUNTS, 2u);      // photons a path
LAMPYRIS_SLOT(SLOT_LEDGER, 3u);           // LEDGER_FLOATS a workgroup
LAMPYRIS_SLOT(SLOT_PATH_OFFSETS, 4u);     // first photon a path, then their total
LAMPYRIS_SLOT(SLOT_PHOTONS, 5u);          // PackedPhoton[], in the order (path, bounce)
LAMPYRIS_SLOT(SLOT_COUNTERS, 6u);         // FrameCounters

// photon_trace with a path store: choice, groups, trace, ledger
LAMPYRIS_SLOT(SLOT_CHOICE_VERTICES, 1u);  // vec4[]: a path's way; as bits, w of the first = how many, w of the second = the turn in which it was drawn
LAMPYRIS_SLOT(SLOT_CHOICE_BOXES, 2u);     // vec4[]: lower and upper corners
LAMPYRIS_SLOT(SLOT_CHOICE_AGAIN, 3u);     // a range: not 0 where its emitter changed
LAMPYRIS_SLOT(SLOT_CHOSEN_PATHS, 4u);     // paths to trace, CHOSEN_ANEW where with new random numbers
LAMPYRIS_SLOT(SLOT_CHOSEN_GROUPS, 5u);    // indirect dispatch over them
LAMPYRIS_SLOT(SLOT_KEPT_VERTICES, 5u);    // as they are written
LAMPYRIS_SLOT(SLOT_BOOKINGS, 7u);         // BOOKING_FLOATS a path
LAMPYRIS_SLOT(CHOSEN_ANEW, 0x80000000u);
LAMPYRIS_SLOT(BOOKED, 15u);               // emitted, absorbed, escaped, in flight, roulette: rgb each
LAMPYRIS_SLOT(BOOKING_FLOATS, 16u);

// photon_trace/importance
LAMPYRIS_SLOT(SLOT_IMPORTANCE_PARAMS, 0u);     // GridParams
LAMPYRIS_SLOT(SLOT_IMPORTANCE_PHOTONS, 1u);    // texels RGBA32Uint, two a photon
LAMPYRIS_SLOT(SLOT_IMPORTANCE_OFFSETS, 2u);    // first photon a path, then their total
LAMPYRIS_SLOT(SLOT_IMPORTANCE_SLOTS, 3u);      // of the grid, a photon
LAMPYRIS_SLOT(SLOT_IMPORTANCE_TABLE, 4u);      // of the grid
LAMPYRIS_SLOT(SLOT_IMPORTANCE_LOOK_UPS, 5u);   // how often each slot was looked up
LAMPYRIS_SLOT(SLOT_IMPORTANCE, 6u);            // a path

// prefix_sum
LAMPYRIS_SLOT(SLOT_SCAN_COUNTS, 0u);
LAMPYRIS_SLOT(SLOT_SCAN_OFFSETS, 1u);
LAMPYRIS_SLOT(SLOT_SCAN_BLOCKS, 2u);
LAMPYRIS_SLOT(SCAN_THREADS, 64u);
LAMPYRIS_SLOT(SCAN_BLOCK, 1024u);         // elements a workgroup

LAMPYRIS_SLOT(TRACE_THREADS, 64u);
LAMPYRIS_SLOT(LEDGER_FLOATS, 16u);        // emitted, absorbed, escaped, in flight, roulette: rgb each; one unused

LAMPYRIS_SLOT(EMIT_SPHERE, 0u);           // `index` is a light; a point on it, then a direction, as in the Thesis
LAMPYRIS_SLOT(EMIT_SURFACE, 1u);          // `index` is an emissive instance's emitter
LAMPYRIS_SLOT(EMIT_DIRECTION, 2u);        // `index` is a light; a direction, then a point: the same light

// The paths [firstPath, firstPath + pathCount) leave one part of an emitter, each with powerPerPath watts.
struct PathRange {
    uint firstPath;
    uint pathCount;
    uint kind;
    uint index;
    vec4 powerPerPath;
    vec4 part;             // of the unit square that ways out are drawn from: its corner, its sides
};

// 32 bytes: position, and power as halves in units of TraceParams.powerScale;
// direction of travel octahedral; what was hit.
struct PackedPhoton {
    uvec4 positionPower;   // position xyz (float bits), power r and g
    uvec4 powerDirection;  // power b and the bounce, direction, instance, front normal
};

struct TraceParams {
    uint firstPath;        // of this batch
    uint pathCount;        // in this batch
    uint rangeCount;
    uint photonsPerPath;   // staged at most
    uint maxBounces;
    uint firstStored;      // hit of a path from a sphere light that is stored first
    uint endStored;        // hits from this on are not stored
    uint rouletteFrom;     // stored hits before roulette begins; 0xffffffff: never
    uint seed;
    float powerScale;      // watts
    uint verticesPerPath;  // with a path store
    uint turn;             // of this frame
};

struct ChoiceParams {
    uint pathCount;
    uint rangeCount;
    uint boxCount;
    uint verticesPerPath;
    uint turns;            // a path is drawn anew every so many frames; 0: never
    uint turn;
    uint all;              // 1: every path is chosen
    uint pad0;
};

struct StoreParams {
    uint pathCount;
    uint photonsPerPath;
    uint capacity;         // photons
    uint pad0;
};

struct FrameCounters {
    uint photonsStored;
    uint photonsDropped;
    uint pairs;            // (tile, photon)
    uint pairsDropped;
    uint mostInTile;
    uint pixelsRecomputed;
    uint photonsNeeded;    // the largest batch's, whether they fitted or not
    uint pairsNeeded;
    uint cells;            // of the irradiance grid, in use
    uint cellsDropped;     // that found no room in it, and photons with them
    uint pathsRetraced;    // with a path store
    uint pad0;
};

LAMPYRIS_SHARED_END
#endif
