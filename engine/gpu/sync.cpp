#include "gpu/sync.h"

#include "gpu/vulkan_result.h"
#include "gpu/vulkan_struct.h"

namespace lampyris::gpu {

core::Result<Fence> createFence(const Device& device, bool signalled, const std::string& name) {
    auto info = vulkanStruct<VkFenceCreateInfo>(VK_STRUCTURE_TYPE_FENCE_CREATE_INFO);
    if (signalled) info.flags = VK_FENCE_CREATE_SIGNALED_BIT;
    VkFence object = VK_NULL_HANDLE;
    VK_TRY(vkCreateFence(device.get(), &info, nullptr, &object));
    setName(device, VK_OBJECT_TYPE_FENCE, object, name);
    return Fence{device.get(), object};
}

core::Result<Semaphore> createSemaphore(const Device& device, const std::string& name) {
    const auto info = vulkanStruct<VkSemaphoreCreateInfo>(VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO);
    VkSemaphore object = VK_NULL_HANDLE;
    VK_TRY(vkCreateSemaphore(device.get(), &info, nullptr, &object));
    setName(device, VK_OBJECT_TYPE_SEMAPHORE, object, name);
    return Semaphore{device.get(), object};
}

core::Result<void> waitAndReset(const Device& device, const Fence& fence) {
    const VkFence object = fence.get();
    VK_TRY(vkWaitForFences(device.get(), 1, &object, VK_TRUE, UINT64_MAX));
    VK_TRY(vkResetFences(device.get(), 1, &object));
    return {};
}

}  // namespace lampyris::gpu
