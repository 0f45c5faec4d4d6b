#include "gpu/adopted_device.h"

#include <cstring>

#include "gpu/device_choice.h"

namespace lampyris::gpu {
namespace {

template <typename T>
const T& as(const VkBaseInStructure& entry) {
    return reinterpret_cast<const T&>(entry);
}

/// Features of the same struct, so that what is behind it in either chain stays.
template <typename T>
void takeOver(T& into, T from) {
    from.pNext = into.pNext;
    into = from;
}

const char* missingHandle(const AdoptedDevice& made) {
    if (made.instance == VK_NULL_HANDLE) return "instance";
    if (made.physical == VK_NULL_HANDLE) return "physical";
    if (made.device == VK_NULL_HANDLE) return "device";
    if (made.queue == VK_NULL_HANDLE) return "queue";
    return made.madeWith == nullptr ? "madeWith" : nullptr;
}

/// Queues with flags of their own are got by another call, and are not looked at.
uint32_t plainQueues(const VkDeviceCreateInfo& madeWith, uint32_t family) {
    for (uint32_t i = 0; i < madeWith.queueCreateInfoCount; ++i) {
        const VkDeviceQueueCreateInfo& queues = madeWith.pQueueCreateInfos[i];
        if (queues.queueFamilyIndex == family && queues.flags == 0) return queues.queueCount;
    }
    return 0;
}

bool isOneOf(VkQueue queue, VkDevice device, uint32_t family, uint32_t count) {
    for (uint32_t i = 0; i < count; ++i) {
        VkQueue made = VK_NULL_HANDLE;
        vkGetDeviceQueue(device, family, i, &made);
        if (made == queue) return true;
    }
    return false;
}

}  // namespace

void readFeatures(const VkDeviceCreateInfo& madeWith, FeatureChain& enabled) {
    if (madeWith.pEnabledFeatures != nullptr) enabled.core.features = *madeWith.pEnabledFeatures;
    for (const auto* entry = static_cast<const VkBaseInStructure*>(madeWith.pNext);
         entry != nullptr; entry = entry->pNext) {
        switch (entry->sType) {
            case VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2:
                takeOver(enabled.core, as<VkPhysicalDeviceFeatures2>(*entry));
                break;
            case VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES:
                takeOver(enabled.v12, as<VkPhysicalDeviceVulkan12Features>(*entry));
                break;
            case VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES:
                takeOver(enabled.v13, as<VkPhysicalDeviceVulkan13Features>(*entry));
                break;
            case VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SYNCHRONIZATION_2_FEATURES:
                enabled.v13.synchronization2 =
                    as<VkPhysicalDeviceSynchronization2Features>(*entry).synchronization2;
                break;
            case VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DYNAMIC_RENDERING_FEATURES:
                enabled.v13.dynamicRendering =
                    as<VkPhysicalDeviceDynamicRenderingFeatures>(*entry).dynamicRendering;
                break;
            case VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_4_FEATURES:
                enabled.v13.maintenance4 =
                    as<VkPhysicalDeviceMaintenance4Features>(*entry).maintenance4;
                break;
            default:
                break;
        }
    }
}

bool hasExtension(const VkDeviceCreateInfo& madeWith, const char* name) {
    for (uint32_t i = 0; i < madeWith.enabledExtensionCount; ++i)
        if (std::strcmp(madeWith.ppEnabledExtensionNames[i], name) == 0) return true;
    return false;
}

core::Result<void> checkAdopted(const AdoptedDevice& made) {
    if (const char* missing = missingHandle(made))
        return core::error("an adopted device lacks AdoptedDevice::{}", missing);
    TRY_VOID(checkPhysical(made.physical));
    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(made.physical, &properties);
    const char* name = properties.deviceName;
    if (!suits(made.physical, made.queueFamily))
        return core::error("{}: queues of family {} do not do graphics and compute with timestamps",
                           name, made.queueFamily);
    const uint32_t queues = plainQueues(*made.madeWith, made.queueFamily);
    if (queues == 0)
        return core::error("{}: was made without a queue of family {} (with no flags)", name,
                           made.queueFamily);
    if (!isOneOf(made.queue, made.device, made.queueFamily, queues))
        return core::error("{}: AdoptedDevice::queue is none of family {}", name, made.queueFamily);
    FeatureChain enabled;
    readFeatures(*made.madeWith, enabled);
    if (const auto missing = missingFeature(enabled))
        return core::error(
            "{}: was made without the feature {}, which gpu::chooseFeatures turns on", name,
            *missing);
    if (vkGetDeviceProcAddr(made.device, "vkCmdPipelineBarrier2") == nullptr)
        return core::error("{}: its instance was made for a Vulkan before 1.3", name);
    return {};
}

}  // namespace lampyris::gpu
