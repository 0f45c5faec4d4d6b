// The four low-resolution texels around a full-resolution pixel, and their bilinear weights. A texel stands at
// its representative pixel's centre, which for an even divisor is half a pixel off the texel's own centre.
#ifndef LAMPYRIS_LIB_COARSE_TAPS
#define LAMPYRIS_LIB_COARSE_TAPS
#include "lib/gather_grid.glsl"

struct CoarseTaps {
    ivec2 texels[4];
    float weights[4];
};

CoarseTaps coarseTaps(ivec2 pixel) {
    vec2 at = vec2(pixel - int(params.divisor / 2u)) / float(params.divisor);
    ivec2 low = ivec2(floor(at));
    vec2 f = at - vec2(low);
    ivec2 top = ivec2(params.coarseWidth, params.coarseHeight) - 1;
    CoarseTaps taps;
    for (int i = 0; i < 4; ++i) {
        ivec2 step = ivec2(i & 1, i >> 1);
        taps.texels[i] = clamp(low + step, ivec2(0), top);
        taps.weights[i] = (step.x == 1 ? f.x : 1.0 - f.x) * (step.y == 1 ? f.y : 1.0 - f.y);
    }
    return taps;
}

#endif
