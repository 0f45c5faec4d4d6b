/// \file SPIR-V handed to the driver.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <span>
#include <string>

#include "core/result.h"
#include "gpu/device.h"
#include "gpu/handle.h"

namespace lampyris::gpu {

using ShaderModule = Handle<VkShaderModule, vkDestroyShaderModule>;

core::Result<ShaderModule> createShaderModule(const Device& device, std::span<const uint32_t> words,
                                              const std::string& name);

}  // namespace lampyris::gpu
