// Slots and per-draw constants of the G-buffer node.
#ifndef LAMPYRIS_SHARED_GBUFFER_H
#define LAMPYRIS_SHARED_GBUFFER_H
#include "shared/glsl_compat.h"

LAMPYRIS_SHARED_BEGIN

// Vertex streams
LAMPYRIS_SLOT(STREAM_POSITION, 0u);
LAMPYRIS_SLOT(STREAM_NORMAL, 1u);
LAMPYRIS_SLOT(STREAM_TANGENT, 2u);
LAMPYRIS_SLOT(STREAM_TEXCOORDS, 3u);
LAMPYRIS_SLOT(STREAM_COLOUR, 4u);

// Attachments, in this order of locations
LAMPYRIS_SLOT(TARGET_NORMAL, 0u);
LAMPYRIS_SLOT(TARGET_ALBEDO, 1u);
LAMPYRIS_SLOT(TARGET_SPECULAR, 2u);
LAMPYRIS_SLOT(TARGET_EMISSION, 3u);

struct GBufferDraw {
    uint instance;
    uint material;
    uint hasTangents;
    uint pad0;
};

LAMPYRIS_SHARED_END
#endif
