// What the morph and skin nodes read: who is posed, how, and from which rest vertices.
#ifndef LAMPYRIS_SHARED_POSE_H
#define LAMPYRIS_SHARED_POSE_H
#include "shared/glsl_compat.h"

LAMPYRIS_SHARED_BEGIN

LAMPYRIS_SLOT(SLOT_POSE_JOBS, 0u);              // storage buffer of PoseJob, by firstThread
LAMPYRIS_SLOT(SLOT_REST_VERTICES, 1u);          // texels RGBA32Uint: REST_TEXELS a vertex
LAMPYRIS_SLOT(SLOT_MORPH_DELTAS, 2u);           // texels RGBA32Float: DELTA_TEXELS a vertex, target by target
LAMPYRIS_SLOT(SLOT_POSES, 3u);                  // texels RGBA32Float: joints and weights of this frame
LAMPYRIS_SLOT(SLOT_POSED_POSITIONS, 4u);        // storage texels RGBA32Float
LAMPYRIS_SLOT(SLOT_POSED_NORMALS, 5u);          // storage texels R32Float: 3 a vertex
LAMPYRIS_SLOT(SLOT_POSED_TANGENTS, 6u);         // storage texels RGBA32Float
LAMPYRIS_SLOT(SLOT_POSED_POSITIONS_BEFORE, 7u); // storage texels RGBA32Float

LAMPYRIS_SLOT(POSE_THREADS, 64u);               // of a workgroup [chosen]
// Workgroups side by side; more stand in further rows: a device may allow no more than 65535 in one. [chosen]
LAMPYRIS_SLOT(POSE_GROUPS_IN_ROW, 32768u);

// (position, joints 0 and 1) (normal, joints 2 and 3) (weights) (tangent): bits of floats, joints in 16 bits each
LAMPYRIS_SLOT(REST_TEXELS, 4u);
// (position's offset) (normal's offset)
LAMPYRIS_SLOT(DELTA_TEXELS, 2u);
// A joint is three rows of its matrix, a weight (weight, number of its target).
LAMPYRIS_SLOT(JOINT_TEXELS, 3u);

// PoseJob.flags
LAMPYRIS_SLOT(POSE_MORPHED, 1u);   // the morph node has a job for the instance
LAMPYRIS_SLOT(POSE_SKINNED, 2u);   // the skin node has one; it comes last

// An instance whose pose changed. Vertices and texels are counted from the beginning of their buffers.
struct PoseJob {
    uint firstThread;   // of the dispatch: one a vertex
    uint vertexCount;
    uint firstVertex;   // in positions and normals
    uint firstTangent;  // or SCENE_NONE
    uint firstBefore;   // vertex in positionsBefore
    uint firstRest;     // vertex in the rest vertices
    uint firstDelta;    // vertex of target 0 in the morph deltas
    uint firstWeight;   // texel in the poses
    uint weightCount;   // targets that count
    uint firstJoint;    // texel in the poses
    uint jointCount;
    uint flags;
};

struct PoseParams {
    uint jobCount;
    uint threadCount;
    uint pad0, pad1;
};

LAMPYRIS_SHARED_END
#endif
