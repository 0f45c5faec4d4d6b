#include "gpu/device_info.h"
#include "gpu/vulkan_struct.h"

#include <fmt/format.h>

#include <algorithm>

namespace lampyris::gpu {
namespace {

const char* kindName(VkPhysicalDeviceType type) {
    switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return "discrete";
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return "integrated";
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return "virtual";
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return "cpu";
        default:
            return "other";
    }
}

uint64_t largestHeap(VkPhysicalDevice physical) {
    VkPhysicalDeviceMemoryProperties memory{};
    vkGetPhysicalDeviceMemoryProperties(physical, &memory);
    uint64_t largest = 0;
    for (uint32_t i = 0; i < memory.memoryHeapCount; ++i)
        if ((memory.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) != 0)
            largest = std::max<uint64_t>(largest, memory.memoryHeaps[i].size);
    return largest;
}

}  // namespace

DeviceInfo readDeviceInfo(VkPhysicalDevice physical, uint32_t queueFamily) {
    auto v11 = vulkanStruct<VkPhysicalDeviceVulkan11Properties>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_PROPERTIES);
    auto v12 = vulkanStruct<VkPhysicalDeviceVulkan12Properties>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_PROPERTIES, &v11);
    auto v13 = vulkanStruct<VkPhysicalDeviceVulkan13Properties>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_PROPERTIES, &v12);
    auto all = vulkanStruct<VkPhysicalDeviceProperties2>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &v13);
    vkGetPhysicalDeviceProperties2(physical, &all);
    const VkPhysicalDeviceProperties& core = all.properties;
    uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());

    DeviceInfo info;
    info.name = core.deviceName;
    info.kind = kindName(core.deviceType);
    info.driver = fmt::format("{} {}", v12.driverName, v12.driverInfo);
    info.apiVersion =
        fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(core.apiVersion),
                    VK_API_VERSION_MINOR(core.apiVersion), VK_API_VERSION_PATCH(core.apiVersion));
    info.limits.core = core.limits;
    info.limits.maxMemoryAllocationSize = v11.maxMemoryAllocationSize;
    info.limits.maxBufferSize = v13.maxBufferSize;
    info.limits.largestHeapBytes = largestHeap(physical);
    info.limits.subgroupSize = v11.subgroupSize;
    info.limits.timestampValidBits = families[queueFamily].timestampValidBits;
    return info;
}

std::vector<std::pair<std::string, uint64_t>> listLimits(const Limits& limits) {
    const VkPhysicalDeviceLimits& core = limits.core;
    return {{"maxImageDimension2D", core.maxImageDimension2D},
            {"maxImageArrayLayers", core.maxImageArrayLayers},
            {"maxTexelBufferElements", core.maxTexelBufferElements},
            {"maxStorageBufferRange", core.maxStorageBufferRange},
            {"maxUniformBufferRange", core.maxUniformBufferRange},
            {"maxPushConstantsSize", core.maxPushConstantsSize},
            {"maxMemoryAllocationSize", limits.maxMemoryAllocationSize},
            {"maxBufferSize", limits.maxBufferSize},
            {"largestHeapBytes", limits.largestHeapBytes},
            {"maxComputeWorkGroupCount[0]", core.maxComputeWorkGroupCount[0]},
            {"maxComputeWorkGroupInvocations", core.maxComputeWorkGroupInvocations},
            {"maxComputeSharedMemorySize", core.maxComputeSharedMemorySize},
            {"maxPerStageDescriptorStorageBuffers", core.maxPerStageDescriptorStorageBuffers},
            {"maxPerStageDescriptorSampledImages", core.maxPerStageDescriptorSampledImages},
            {"maxPerStageDescriptorStorageImages", core.maxPerStageDescriptorStorageImages},
            {"maxPerStageResources", core.maxPerStageResources},
            {"subgroupSize", limits.subgroupSize},
            {"timestampValidBits", limits.timestampValidBits}};
}

}  // namespace lampyris::gpu
