// Slots and parameters of the display transform.
#ifndef LAMPYRIS_SHARED_DISPLAY_H
#define LAMPYRIS_SHARED_DISPLAY_H
#include "shared/glsl_compat.h"

LAMPYRIS_SHARED_BEGIN

LAMPYRIS_SLOT(SLOT_DISPLAY_RADIANCE, 0u);
LAMPYRIS_SLOT(SLOT_DISPLAY_SHOWN, 1u);

LAMPYRIS_SLOT(DISPLAY_CLIP, 0u);
LAMPYRIS_SLOT(DISPLAY_FILMIC, 1u);

struct DisplayParams {
    float gain;      // 2^EV
    uint tonemap;    // DISPLAY_…
};

LAMPYRIS_SHARED_END
#endif
