/// \file A bilinear look-up on the CPU, as lib/texture_lookup.glsl does it.
#pragma once

#include "assets/material.h"

namespace lampyris::residency {

/// Linear RGB of an sRGB image, with the wrap modes and filter of the use.
[[nodiscard]] glm::vec3 lookUpSrgb(const assets::TextureImage& image, const assets::TextureUse& use,
                                   glm::vec2 uv);

}  // namespace lampyris::residency
