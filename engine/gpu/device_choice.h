/// \file Which physical device: discrete before integrated before CPU, able to do what we need.
#pragma once

#include <vulkan/vulkan.h>

#include <string>
#include <string_view>

#include "core/result.h"

namespace lampyris::gpu {

struct ChosenDevice {
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    uint32_t queueFamily = 0;  ///< graphics, compute and transfer in one
};

/// The best device whose name contains `substring` (any case; empty matches all). An Error lists
/// the devices where none matches, or names the feature or limit that the best one lacks.
core::Result<ChosenDevice> chooseDevice(VkInstance instance, std::string_view substring);

}  // namespace lampyris::gpu
