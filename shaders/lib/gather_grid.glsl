// How low-resolution texels map to pixels, for every node that gathers or up-samples. COARSE_PARAMS: the struct of
// push constants, if not the gather's.
#ifndef LAMPYRIS_LIB_GATHER_GRID
#define LAMPYRIS_LIB_GATHER_GRID
#include "lib/view_space.glsl"
#ifndef COARSE_PARAMS
#include "shared/tile_bin.h"
#define COARSE_PARAMS GatherParams
#endif

layout(push_constant) uniform Push { COARSE_PARAMS params; };

// The full-resolution pixel that a low-resolution texel stands for: the one at its middle.
ivec2 representative(ivec2 texel) {
    return min(texel * int(params.divisor) + int(params.divisor / 2u), ivec2(view.width, view.height) - 1);
}

#endif
