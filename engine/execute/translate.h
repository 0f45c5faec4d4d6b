/// \file The one place where the graph's words become Vulkan's: formats, accesses, layouts.
#pragma once

#include <vulkan/vulkan.h>

#include "graph/access.h"
#include "graph/compiled.h"
#include "graph/resource.h"
#include "graph/shader.h"

namespace lampyris::execute {

[[nodiscard]] VkFormat formatOf(graph::Format format);
[[nodiscard]] VkImageLayout layoutOf(graph::Layout layout);
[[nodiscard]] VkDescriptorType descriptorTypeOf(graph::SlotKind kind);
/// What an image must be created for.
[[nodiscard]] VkImageUsageFlags imageUsageOf(graph::AccessSet accesses);

/// One side of a dependency.
struct Scope {
    VkPipelineStageFlags2 stages = 0;
    VkAccessFlags2 accesses = 0;
};

[[nodiscard]] Scope scopeOf(graph::Touch touch);
[[nodiscard]] Scope scopeOf(const graph::TouchSet& touches);

}  // namespace lampyris::execute
