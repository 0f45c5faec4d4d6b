// The camera of a frame, as every screen-space node sees it, and the 8 × 8 tiles of the screen.
#ifndef LAMPYRIS_SHARED_VIEW_H
#define LAMPYRIS_SHARED_VIEW_H
#include "shared/glsl_compat.h"

LAMPYRIS_SHARED_BEGIN

LAMPYRIS_SLOT(SLOT_VIEW, 15u);      // uniform buffer of every node that knows a camera
LAMPYRIS_SLOT(TILE_PIXELS, 8u);     // a tile is 8 × 8 full-resolution pixels [Thesis 5.3.3.1]

struct View {
    mat4 worldToClip;
    mat4 worldToView;         // rigid; the camera looks along -z
    mat4 viewToWorld;
    vec4 projection;          // x = cot(fov/2)/aspect, y = cot(fov/2), z = near plane in metres, w = 0
    uint width;               // pixels
    uint height;
    uint tilesX;
    uint tilesY;
};

LAMPYRIS_SHARED_END
#endif
