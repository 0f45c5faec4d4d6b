// What the mean of light over frames is told: where the frame before looked from, and what changed since.
#ifndef LAMPYRIS_SHARED_HISTORY_H
#define LAMPYRIS_SHARED_HISTORY_H
#include "shared/glsl_compat.h"

LAMPYRIS_SHARED_BEGIN

// Beside the final gather's slots 2, 3, 4 and 6 (see tile_bin.h).
LAMPYRIS_SLOT(SLOT_HISTORY_PARAMS, 0u);         // HistoryParams
LAMPYRIS_SLOT(SLOT_HISTORY_BEFORE, 1u);         // mean irradiance, a = frames in it
LAMPYRIS_SLOT(SLOT_HISTORY_GUIDE_BEFORE, 5u);
LAMPYRIS_SLOT(SLOT_HISTORY_SLOPE_BEFORE, 7u);
LAMPYRIS_SLOT(SLOT_HISTORY_MEAN, 8u);           // as it goes on to the next frame
LAMPYRIS_SLOT(SLOT_HISTORY_SLOPE, 9u);
LAMPYRIS_SLOT(SLOT_HISTORY_CHANGES, 10u);       // ChangedPlace[]: regions, then lights
LAMPYRIS_SLOT(SLOT_HISTORY_MOMENTS_BEFORE, 11u);
LAMPYRIS_SLOT(SLOT_HISTORY_MOMENTS, 12u);       // of the newest light around a texel: mean, mean square
LAMPYRIS_SLOT(SLOT_HISTORY_MOTION, 13u);        // to where a pixel's surface was in the frame before, metres

// A box in which geometry changed, or a light.
struct ChangedPlace {
    vec4 lowerMoved;    // box or light: xyz world; w = metres that it moved
    vec4 upperWatts;    // box: xyz world; light: w = watts, mean of the channels
    vec4 changedWatts;  // light: x = watts that came or went
};

struct HistoryParams {
    mat4 worldToClipBefore;  // of the frame before
    uint mostFrames;         // that may be in the mean besides the newest; 0: it begins anew
    uint regionCount;
    uint lightCount;         // 0 where no light changed
    uint doubted;            // 1: something changed not long ago, its light may still be on its way out of the mean
};

LAMPYRIS_SHARED_END
#endif
