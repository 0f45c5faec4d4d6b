// What the refit nodes read: one job a BLAS that is refitted. Written by modules/accel/refit_nodes.cpp.
#ifndef LAMPYRIS_SHARED_REFIT_H
#define LAMPYRIS_SHARED_REFIT_H

#include "shared/glsl_compat.h"

LAMPYRIS_SHARED_BEGIN

LAMPYRIS_SLOT(SLOT_REFIT_JOBS, 0u);           // GpuRefitJob[], ascending in firstGroup
LAMPYRIS_SLOT(SLOT_REFIT_SLOTS, 1u);          // texels R32Uint: a child's texel, relative to its tree's first
LAMPYRIS_SLOT(SLOT_REFIT_NODES, 2u);          // texels RGBA32Uint, as SLOT_BVH_NODES
LAMPYRIS_SLOT(SLOT_REFIT_NEW_NODES, 3u);      // the same, to write
LAMPYRIS_SLOT(SLOT_REFIT_TRIANGLES, 4u);      // texels RGBA32Uint, as SLOT_BVH_TRIANGLES
LAMPYRIS_SLOT(SLOT_REFIT_NEW_TRIANGLES, 5u);  // the same, to write
LAMPYRIS_SLOT(SLOT_REFIT_POSITIONS, 6u);      // texels RGBA32Float
LAMPYRIS_SLOT(SLOT_REFIT_INDICES, 7u);        // texels R32Uint
LAMPYRIS_SLOT(SLOT_REFIT_QUALITY, 8u);        // uint[]: dropped triangles a job, then parts of costs as floats

LAMPYRIS_SLOT(REFIT_THREADS, 64u);
LAMPYRIS_SLOT(REFIT_COST_TEXELS, 128u);  // child texels a part of a tree's cost

struct GpuRefitJob {
    vec4 gridOffset;     // as GpuBvhGrid
    vec4 cellsPerMetre;  // reciprocals of its cell
    vec4 gridCell;
    uint firstGroup;     // workgroup of this dispatch
    uint count;          // invocations: slots, or parts of the cost and one more
    uint firstSlot;      // into SLOT_REFIT_SLOTS
    uint firstTexel;     // of the tree's nodes
    uint texels;         // of the tree's nodes
    uint firstVertex;    // of its posed range
    uint firstIndex;     // of its mesh
    uint quality;        // refit_leaves: the job's counter; refit_sah: the root's area, then the parts
};

struct RefitPush {
    uint jobs;
    uint pad0, pad1, pad2;
};

LAMPYRIS_SHARED_END

#endif
