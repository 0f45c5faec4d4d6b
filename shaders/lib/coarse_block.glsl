// The pixels between four low-resolution texels: one thread takes such a block and fetches the texels once. A texel
// stands at its representative pixel's centre; the weights of the four are bilinear between those.
#ifndef LAMPYRIS_LIB_COARSE_BLOCK
#define LAMPYRIS_LIB_COARSE_BLOCK
#include "lib/gather_grid.glsl"

// Block b lies between texels b − 1 and b of each axis; there is one more than texels.
ivec2 texelOf(ivec2 block, int corner) {
    ivec2 texel = block - 1 + ivec2(corner & 1, corner >> 1);
    return clamp(texel, ivec2(0), ivec2(params.coarseWidth, params.coarseHeight) - 1);
}

// The block's pixels begin at its first texel's representative; those of border blocks may lie outside the image.
ivec2 firstPixel(ivec2 block) { return (block - 1) * int(params.divisor) + int(params.divisor / 2u); }

// Pixels from the first texels' representatives to the last ones': the divisor, but less at the image's far edges.
vec2 blockSpan(ivec2 block) { return vec2(max(representative(block) - firstPixel(block), ivec2(1))); }

// Weights of the four texels at a pixel of the block.
vec4 texelWeights(ivec2 pixelInBlock, vec2 span) {
    vec2 f = min(vec2(pixelInBlock) / span, vec2(1.0));
    return vec4((1.0 - f.x) * (1.0 - f.y), f.x * (1.0 - f.y), (1.0 - f.x) * f.y, f.x * f.y);
}

bool inImage(ivec2 pixel) {
    return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, ivec2(view.width, view.height)));
}

#endif
