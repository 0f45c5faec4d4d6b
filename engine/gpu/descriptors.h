/// \file Descriptor set layouts, pipeline layouts, and pools that grow.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"
#include "gpu/device.h"
#include "gpu/handle.h"

namespace lampyris::gpu {

using DescriptorLayout = Handle<VkDescriptorSetLayout, vkDestroyDescriptorSetLayout>;
using PipelineLayout = Handle<VkPipelineLayout, vkDestroyPipelineLayout>;

core::Result<DescriptorLayout> createDescriptorLayout(
    const Device& device, std::span<const VkDescriptorSetLayoutBinding> bindings,
    const std::string& name);

/// One set and, where `pushBytes` is not 0, one range of push constants from byte 0.
core::Result<PipelineLayout> createPipelineLayout(const Device& device, VkDescriptorSetLayout set,
                                                  uint32_t pushBytes, VkShaderStageFlags pushStages,
                                                  const std::string& name);

/// Gives out sets; all go back at once with reset(). Sets have no names: they live for a frame, and
/// lavapipe keeps a name past vkResetDescriptorPool. The label of their node says whose they are.
class DescriptorPool {
 public:
    explicit DescriptorPool(Device& device) : device_(&device) {}
    core::Result<VkDescriptorSet> allocate(VkDescriptorSetLayout layout);
    core::Result<void> reset();

 private:
    core::Result<void> grow();
    Device* device_;
    std::vector<Handle<VkDescriptorPool, vkDestroyDescriptorPool>> pools_;
    size_t current_ = 0;
};

}  // namespace lampyris::gpu
