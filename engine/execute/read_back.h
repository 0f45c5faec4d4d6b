/// \file From device memory to the host, after a frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/result.h"
#include "execute/resources.h"
#include "gpu/commands.h"
#include "graph/compiled.h"
#include "graph/frame.h"

namespace lampyris::execute {

/// The contents of images and buffers (by resource, in that order), in one submission that it waits
/// for. An Error names a resource that the frame does not keep to its end.
core::Result<std::vector<std::vector<std::byte>>> readBack(gpu::Device& device,
                                                           gpu::Commands& commands,
                                                           const graph::Frame& frame,
                                                           const graph::CompiledGraph& graph,
                                                           const Resources& resources,
                                                           std::span<const uint32_t> wanted);

}  // namespace lampyris::execute
