/// \file A Vulkan device that somebody else made and keeps: what Device::adopt must be told of it,
/// and what it must have.
///
///     gpu::FeatureChain features;                  // the game sets what it wants itself
///     gpu::chooseFeatures(physical, features);     // and this adds what the engine wants
///     VkDeviceCreateInfo info{…};
///     info.pNext = &features.core;                 // or a chain of the game's own
///     vkCreateDevice(physical, &info, nullptr, &made);
///     auto device = gpu::Device::adopt({instance, physical, made, queue, family, &info});
#pragma once

#include <vulkan/vulkan.h>

#include "core/result.h"
#include "gpu/device_features.h"

namespace lampyris::gpu {

/// None of it is ever destroyed by us, and all of it must outlive the Device. Vulkan cannot be
/// asked what was turned on, so `madeWith` tells.
struct AdoptedDevice {
    VkInstance instance = VK_NULL_HANDLE;  ///< of Vulkan 1.3 (VkApplicationInfo::apiVersion)
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    /// Of `queueFamily`, made without flags; nobody else uses it during a call of ours.
    VkQueue queue = VK_NULL_HANDLE;
    uint32_t queueFamily = 0;  ///< graphics and compute, with timestamps
    /// What vkCreateDevice was given: features are read from pNext and pEnabledFeatures, extensions
    /// and queues from their lists. Read by adopt() alone, so it need not outlive it.
    const VkDeviceCreateInfo* madeWith = nullptr;
    bool debugUtils = false;  ///< the instance has VK_EXT_debug_utils: for names and labels
};

/// Which of the features that we know a device was made with: those of VkPhysicalDeviceFeatures2,
/// of the structs for 1.2 and 1.3, and of those for single features that became part of 1.3.
void readFeatures(const VkDeviceCreateInfo& madeWith, FeatureChain& enabled);

/// Whether the device was made with an extension.
[[nodiscard]] bool hasExtension(const VkDeviceCreateInfo& madeWith, const char* name);

/// An Error names the handle, version, queue, queue ability, feature or limit that is missing.
core::Result<void> checkAdopted(const AdoptedDevice& made);

}  // namespace lampyris::gpu
