/// \file From device memory to core::Image and bytes, after a frame.
#pragma once

#include <cstddef>
#include <vector>

#include "core/image.h"
#include "core/result.h"
#include "execute/resources.h"
#include "gpu/commands.h"
#include "graph/compiled.h"
#include "graph/frame.h"

namespace lampyris::execute {

/// All texels of an image as the device has them, layer by layer, row by row, tightly packed.
struct RawImage {
    graph::ImageDesc desc;
    std::vector<std::byte> bytes;
};

/// As floats, of the first layer: unorm as 0 to 1, sRGB decoded, uints as the nearest float. BGRA
/// comes out as RGBA.
[[nodiscard]] core::Image toImage(const RawImage& raw);

/// Errors name a resource that the frame does not keep to its end.
core::Result<RawImage> readImage(gpu::Device& device, gpu::Commands& commands,
                                 const graph::Frame& frame, const graph::CompiledGraph& graph,
                                 const Resources& resources, graph::Image image);
core::Result<std::vector<std::byte>> readBuffer(gpu::Device& device, const graph::Frame& frame,
                                                const graph::CompiledGraph& graph,
                                                const Resources& resources, graph::Buffer buffer);

}  // namespace lampyris::execute
