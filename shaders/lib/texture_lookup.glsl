// A texture as a material uses it (see shared/scene.h): bilinear at the base level of an array of layers whose
// sampler repeats; clamping, mirroring and nearest filtering are done on the coordinates.
#ifndef LAMPYRIS_LIB_TEXTURE_LOOKUP
#define LAMPYRIS_LIB_TEXTURE_LOOKUP
#include "shared/scene.h"

float wrapCoordinate(float u, float size, uint use, uint clampBit, uint mirrorBit) {
    if ((use & mirrorBit) != 0u) {
        float period = u - 2.0 * floor(0.5 * u);
        u = period > 1.0 ? 2.0 - period : period;
    }
    // Half a texel from the border the filter would reach across it.
    if ((use & (clampBit | mirrorBit)) != 0u) u = clamp(u, 0.5 / size, 1.0 - 0.5 / size);
    if ((use & TEXTURE_NEAREST) != 0u) u = (floor(u * size) + 0.5) / size;
    return u;
}

// `texcoords` holds both sets; `absent` is the answer where there is no texture.
vec4 lookUpTexture(sampler2DArray textures, uint use, vec4 texcoords, vec4 absent) {
    if (use == SCENE_NONE) return absent;
    vec2 uv = (use & TEXTURE_SECOND_SET) != 0u ? texcoords.zw : texcoords.xy;
    vec2 size = vec2(textureSize(textures, 0).xy);
    uv.x = wrapCoordinate(uv.x, size.x, use, TEXTURE_CLAMP_U, TEXTURE_MIRROR_U);
    uv.y = wrapCoordinate(uv.y, size.y, use, TEXTURE_CLAMP_V, TEXTURE_MIRROR_V);
    return textureLod(textures, vec3(uv, float(use & TEXTURE_LAYER_MASK)), 0.0);
}

#endif
