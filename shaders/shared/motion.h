// Slots and per-draw constants of the motion node.
#ifndef LAMPYRIS_SHARED_MOTION_H
#define LAMPYRIS_SHARED_MOTION_H
#include "shared/glsl_compat.h"

LAMPYRIS_SHARED_BEGIN

// Vertex streams
LAMPYRIS_SLOT(STREAM_MOTION_POSITION, 0u);
LAMPYRIS_SLOT(STREAM_MOTION_BEFORE, 1u);

LAMPYRIS_SLOT(TARGET_MOTION, 0u);

struct MotionDraw {
    vec4 objectToWorldBefore0, objectToWorldBefore1, objectToWorldBefore2;  // rows
    uint instance;
    uint pad0, pad1, pad2;
};

LAMPYRIS_SHARED_END
#endif
