/// \file Texels as the device has them, and as a core::Image.
#pragma once

#include <cstddef>
#include <vector>

#include "core/image.h"
#include "graph/resource.h"

namespace lampyris::execute {

/// All texels of an image, bit by bit: layer by layer, row by row, tightly packed.
struct RawImage {
    graph::ImageDesc desc;
    std::vector<std::byte> bytes;
};

/// As floats, of the first layer: unorm as 0 to 1, sRGB decoded, uints as the nearest float. BGRA
/// comes out as RGBA.
[[nodiscard]] core::Image toImage(const RawImage& raw);

}  // namespace lampyris::execute
