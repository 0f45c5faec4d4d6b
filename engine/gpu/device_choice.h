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

/// Whether the engine can run on it; an Error names the version, feature or limit that it lacks.
core::Result<void> checkPhysical(VkPhysicalDevice physical);
/// Whether queues of the family do graphics and compute, and write timestamps.
[[nodiscard]] bool suits(VkPhysicalDevice physical, uint32_t queueFamily);

}  // namespace lampyris::gpu
