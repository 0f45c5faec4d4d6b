/// \file The layout of descriptor set 0 and of the push constants, from what reflection found.
#pragma once

#include <vulkan/vulkan.h>

#include <span>
#include <string>
#include <vector>

#include "core/result.h"
#include "gpu/descriptors.h"
#include "graph/shader.h"

namespace lampyris::execute {

struct StageShader {
    const graph::Shader* shader = nullptr;
    VkShaderStageFlagBits stage = VK_SHADER_STAGE_COMPUTE_BIT;
};

/// The slots of all stages form one set.
struct SetLayout {
    gpu::DescriptorLayout set;
    gpu::PipelineLayout pipeline;
    std::vector<graph::ShaderSlot> slots;
    uint32_t pushBytes = 0;
    VkShaderStageFlags pushStages = 0;
    VkPipelineBindPoint bindPoint = VK_PIPELINE_BIND_POINT_COMPUTE;
};

/// An Error names the shader and the limit that its slots exceed.
core::Result<SetLayout> makeSetLayout(const gpu::Device& device,
                                      std::span<const StageShader> stages);

}  // namespace lampyris::execute
