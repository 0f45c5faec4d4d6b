/// \file Descriptor sets from what a node declared.
#pragma once

#include <vulkan/vulkan.h>

#include <array>

#include "core/result.h"
#include "execute/set_layouts.h"
#include "gpu/sampler.h"
#include "graph/node.h"

namespace lampyris::execute {

struct Recording;

/// One sampler for each pair of filtering and addressing.
class Samplers {
 public:
    static core::Result<Samplers> create(const gpu::Device& device);
    [[nodiscard]] VkSampler get(graph::Filtering filtering, graph::Addressing addressing) const;

 private:
    std::array<gpu::Sampler, 4> samplers_;
};

/// A set with everything that `layout` has a slot for. Errors name the node, the slot and the limit
/// in the way: maxStorageBufferRange, maxTexelBufferElements, an offset's alignment.
core::Result<VkDescriptorSet> makeDescriptorSet(Recording& recording, const graph::Node& node,
                                                const SetLayout& layout);

}  // namespace lampyris::execute
