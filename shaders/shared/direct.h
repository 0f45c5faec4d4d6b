// Slots and parameters of the direct light: tile bounds, lights' reach, light lists, shadows, shading.
#ifndef LAMPYRIS_SHARED_DIRECT_H
#define LAMPYRIS_SHARED_DIRECT_H
#include "shared/glsl_compat.h"

LAMPYRIS_SHARED_BEGIN

LAMPYRIS_SLOT(SLOT_TILE_BOUNDS, 0u);       // vec2 a tile: least and greatest view depth; least > greatest: no surface
LAMPYRIS_SLOT(SLOT_LIGHT_REACH, 2u);       // float a light: metres, then cut-off watts r, g, b
LAMPYRIS_SLOT(SLOT_LIGHT_MASKS, 3u);       // words a tile: lights that reach it, then lights whose disc it may show
LAMPYRIS_SLOT(SLOT_SHADOW_COUNTS, 5u);     // image, DirectParams.planes layers for 32 lights: bit i of how many rays saw each
LAMPYRIS_SLOT(SLOT_SHADOW_SHARES, 4u);     // image, SHARE_PLANES layers for 32 lights: bit i of a 31st of each that is seen
LAMPYRIS_SLOT(SLOT_IRRADIANCE_DIRECT, 5u);
LAMPYRIS_SLOT(SLOT_SPECULAR_DIRECT, 6u);
LAMPYRIS_SLOT(SLOT_SHOWN, 7u);
LAMPYRIS_SLOT(SLOT_SHADOW_GUIDE, 1u);      // image: where each texel stands
LAMPYRIS_SLOT(SLOT_SHADOW_LIST, 8u);       // uvec2: a pixel that traces rays of its own, x | y << 16; its lights, of one word
LAMPYRIS_SLOT(SLOT_SHADOW_LISTED, 9u);     // their number
LAMPYRIS_SLOT(SLOT_SHADOW_GROUPS, 0u);     // indirect dispatch over them

LAMPYRIS_SLOT(SHADOW_MOST_PLANES, 5u);
LAMPYRIS_SLOT(SHARE_PLANES, 5u);
LAMPYRIS_SLOT(SHARE_WHOLE, 31u);

// Specialization constants.
LAMPYRIS_SLOT(SPEC_MANY_LIGHTS, 0u);       // 0: one word of lights
LAMPYRIS_SLOT(SPEC_ANY_SPECULAR, 1u);      // 0: every surface is Lambertian

LAMPYRIS_SLOT(REACH_THREADS, 256u);

struct DirectParams {
    uint lightCount;
    uint maskWords;        // 32-bit words a tile and purpose
    float cutoff;          // of the frame's mean direct irradiance; 0 = lights reach everywhere
    uint seed;
    uint reachGrid;        // samples of the frame, an axis, that the mean irradiance is taken from
    uint divisor;          // shadows' low resolution, an axis
    uint coarseWidth;
    uint coarseHeight;
    uint rays;             // shadow rays a light and texel
    uint planes;           // bits that hold their number
    uint pad0, pad1;
};

LAMPYRIS_SLOT(SHOW_ALBEDO, 0u);
LAMPYRIS_SLOT(SHOW_NORMAL, 1u);
LAMPYRIS_SLOT(SHOW_POSITION, 2u);
LAMPYRIS_SLOT(SHOW_DEPTH, 3u);
LAMPYRIS_SLOT(SHOW_EMISSION, 4u);

LAMPYRIS_SHARED_END
#endif
