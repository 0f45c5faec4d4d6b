/// \file A texture as a material uses it: bilinear at the base level, with its wrap modes.
#pragma once

#include <cstdint>

#include "assets/material.h"

namespace lampyris::reference {

enum class Encoding : uint8_t { Linear, Srgb };

/// RGBA from 0 to 1 at texture coordinates. sRGB texels are decoded before they are mixed; alpha
/// always is linear.
[[nodiscard]] glm::vec4 lookUp(const assets::TextureImage& image, const assets::TextureUse& use,
                               glm::vec2 uv, Encoding encoding);

}  // namespace lampyris::reference
