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
/// The first required feature that is off in the chain, or nothing.
[[nodiscard]] std::optional<std::string> missingFeature(FeatureChain& enabled);
/// The names of all features we know of that are on in the chain.
[[nodiscard]] std::vector<std::string> enabledFeatures(FeatureChain& enabled);

/// Turns on what is required, and what is optional and there; leaves all else in the chain as it
/// is. Gives their names. No device extension is needed but VK_KHR_swapchain, to show images in a
/// window.
std::vector<std::string> chooseFeatures(VkPhysicalDevice physical, FeatureChain& chain);

}  // namespace lampyris::gpu
