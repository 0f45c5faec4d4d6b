/// \file Compute pipelines.
#pragma once

#include <vulkan/vulkan.h>

#include <span>
#include <string>
#include <utility>

#include "core/result.h"
#include "gpu/device.h"
#include "gpu/handle.h"

namespace lampyris::gpu {

using Pipeline = Handle<VkPipeline, vkDestroyPipeline>;

/// A specialization constant: its id in the shader, and 4 bytes of value.
struct SpecialisationValue {
    uint32_t id = 0;
    uint32_t value = 0;
};

struct ComputePipelineOptions {
    VkShaderModule module = VK_NULL_HANDLE;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    std::span<const SpecialisationValue> specialisation{};
    std::string name{};
};

core::Result<Pipeline> createComputePipeline(Device& device, const ComputePipelineOptions& options);

}  // namespace lampyris::gpu
