// The G-buffer: 24 bytes a pixel beside the Thesis's 72, and who reads it where.
//   depth     D32F     reversed, 0 = background            4
//   normal    R32UI    world space, octahedral snorm16     4
//   albedo    RGBA16F  diffuse albedo, a = roughness       8
//   specular  RGBA8    sqrt of reflectance at normal incidence  4
//   emission  R32UI    radiance, shared exponent           4
#ifndef LAMPYRIS_SHARED_SURFACE_H
#define LAMPYRIS_SHARED_SURFACE_H
#include "shared/glsl_compat.h"

LAMPYRIS_SHARED_BEGIN

LAMPYRIS_SLOT(SLOT_SURFACE_DEPTH, 10u);
LAMPYRIS_SLOT(SLOT_SURFACE_NORMAL, 11u);
LAMPYRIS_SLOT(SLOT_SURFACE_ALBEDO, 12u);
LAMPYRIS_SLOT(SLOT_SURFACE_SPECULAR, 13u);
LAMPYRIS_SLOT(SLOT_SURFACE_EMISSION, 14u);

LAMPYRIS_SHARED_END
#endif
