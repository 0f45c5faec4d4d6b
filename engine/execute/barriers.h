/// \file Recording of barriers, layout changes and clears.
#pragma once

#include <vulkan/vulkan.h>

#include <vector>

#include "execute/resources.h"
#include "gpu/image.h"
#include "graph/compiled.h"

namespace lampyris::execute {

/// A step's dependencies, as compile() derived them.
void recordHandover(VkCommandBuffer commands, const graph::MemoryBarrier& handover);
void recordBarriers(VkCommandBuffer commands, const std::vector<graph::Barrier>& barriers,
                    const Resources& resources);

/// Between copies of one transfer node.
void recordTransferBarrier(VkCommandBuffer commands);

/// Changes the layout of a whole image, with a full dependency. For what stands outside the graph.
void changeLayout(VkCommandBuffer commands, const gpu::Image& image, VkImageLayout before,
                  VkImageLayout after);

/// Clears a whole image, which is in the transfer target layout.
void clearImage(VkCommandBuffer commands, const gpu::Image& image, const VkClearValue& value);

}  // namespace lampyris::execute
