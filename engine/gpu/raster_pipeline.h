/// \file Graphics pipelines for dynamic rendering.
#pragma once

#include <vulkan/vulkan.h>

#include <span>
#include <string>

#include "core/result.h"
#include "gpu/compute_pipeline.h"
#include "gpu/device.h"

namespace lampyris::gpu {

/// Viewport and scissor are dynamic; front faces are counter-clockwise in a viewport
/// whose y points down.
struct RasterPipelineOptions {
    VkShaderModule vertex = VK_NULL_HANDLE;
    VkShaderModule fragment = VK_NULL_HANDLE;  ///< null: depth only
    VkPipelineLayout layout = VK_NULL_HANDLE;
    std::span<const VkVertexInputBindingDescription> streams{};
    std::span<const VkVertexInputAttributeDescription> attributes{};
    std::span<const VkFormat> colours{};
    VkFormat depth = VK_FORMAT_UNDEFINED;
    bool depthTest = true;  ///< greater or equal passes
    bool depthWrite = true;
    bool depthEqual = false;  ///< only equal passes
    bool lines = false;
    bool blend = false;  ///< colour over what is there, by the fragment's alpha
    std::string name{};
};

core::Result<Pipeline> createRasterPipeline(Device& device, const RasterPipelineOptions& options);

}  // namespace lampyris::gpu
