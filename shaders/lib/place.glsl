// Where a vertex stands in the world. One arithmetic for all raster nodes, so that their depths are equal.
#ifndef LAMPYRIS_LIB_PLACE
#define LAMPYRIS_LIB_PLACE
#include "shared/scene.h"

vec3 placed(vec3 position, vec4 row0, vec4 row1, vec4 row2) {
    vec4 p = vec4(position, 1.0);
    return vec3(dot(row0, p), dot(row1, p), dot(row2, p));
}

#endif
