/// \file The device features that the engine turns on, each with the reason it is needed.
#pragma once

#include <vulkan/vulkan.h>

#include <optional>
#include <string>
#include <vector>

#include "gpu/vulkan_struct.h"

namespace lampyris::gpu {

/// The chain handed to vkCreateDevice. Not movable: it points into itself.
struct FeatureChain {
    VkPhysicalDeviceFeatures2 core =
        vulkanStruct<VkPhysicalDeviceFeatures2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2);
    VkPhysicalDeviceVulkan12Features v12 = vulkanStruct<VkPhysicalDeviceVulkan12Features>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES);
    VkPhysicalDeviceVulkan13Features v13 = vulkanStruct<VkPhysicalDeviceVulkan13Features>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES);

    FeatureChain();
    FeatureChain(const FeatureChain&) = delete;
    FeatureChain& operator=(const FeatureChain&) = delete;
};

/// The first required feature that the device lacks, or nothing.
[[nodiscard]] std::optional<std::string> missingFeature(VkPhysicalDevice physical);

/// Turns on what is required, and what is optional and there. Gives their names.
std::vector<std::string> chooseFeatures(VkPhysicalDevice physical, FeatureChain& chain);

}  // namespace lampyris::gpu
