// The tiles' depth bounds, for the kernels that test photons against tiles.
#ifndef LAMPYRIS_LIB_BIN_BOUNDS
#define LAMPYRIS_LIB_BIN_BOUNDS
#include "lib/view_space.glsl"
#include "shared/tile_bin.h"

layout(set = 0, binding = SLOT_BIN_BOUNDS) uniform samplerBuffer binBounds;

// Least and greatest depth, metres; least above greatest where the tile shows no surface.
vec2 boundsOf(uvec2 tile) { return texelFetch(binBounds, int(tile.y * view.tilesX + tile.x)).xy; }

#endif
