// Reading the G-buffer. Define SURFACE_MATERIAL to have the material images bound too.
#ifndef LAMPYRIS_LIB_SURFACE
#define LAMPYRIS_LIB_SURFACE
#include "lib/pack.glsl"
#include "lib/view_space.glsl"
#include "shared/surface.h"

layout(set = 0, binding = SLOT_SURFACE_DEPTH) uniform sampler2D surfaceDepth;
layout(set = 0, binding = SLOT_SURFACE_NORMAL) uniform usampler2D surfaceNormal;
#ifdef SURFACE_MATERIAL
layout(set = 0, binding = SLOT_SURFACE_ALBEDO) uniform sampler2D surfaceAlbedo;
layout(set = 0, binding = SLOT_SURFACE_SPECULAR) uniform sampler2D surfaceSpecular;
layout(set = 0, binding = SLOT_SURFACE_EMISSION) uniform usampler2D surfaceEmission;
#endif

bool insideImage(ivec2 pixel) { return all(lessThan(pixel, ivec2(view.width, view.height))); }
float depthAt(ivec2 pixel) { return texelFetch(surfaceDepth, pixel, 0).r; }
vec3 normalAt(ivec2 pixel) { return unpackDirection(texelFetch(surfaceNormal, pixel, 0).r); }

#endif
