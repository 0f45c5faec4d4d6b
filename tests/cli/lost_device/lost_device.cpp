// A device that is lost, for a program that is started with this in LD_PRELOAD. Once the file named
// by LAMPYRIS_LOST_DEVICE exists, as many more submissions as it says go to the device; the next
// one is taken and never done, and from then on every call that may tell so tells that it is lost.
#include <dlfcn.h>
#include <vulkan/vulkan.h>

#include <atomic>
#include <cstdlib>
#include <fstream>

namespace {

constexpr int64_t kNotYet = -1;
std::atomic<int64_t> submissionsLeft{kNotYet};
std::atomic<bool> lost{false};

/// The function of that name that this one stands before.
template <typename Function>
Function original(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

bool isLostNow() {
    if (submissionsLeft == kNotYet) {
        const char* path = std::getenv("LAMPYRIS_LOST_DEVICE");
        int64_t left = 0;
        if (path == nullptr || !(std::ifstream(path) >> left)) return false;
        submissionsLeft = left;
    }
    return submissionsLeft-- == 0;
}

}  // namespace

extern "C" {

VKAPI_ATTR VkResult VKAPI_CALL vkQueueSubmit2(VkQueue queue, uint32_t count,
                                              const VkSubmitInfo2* submits, VkFence fence) {
    static const auto next = original<PFN_vkQueueSubmit2>("vkQueueSubmit2");
    if (lost) return VK_ERROR_DEVICE_LOST;
    if (!isLostNow()) return next(queue, count, submits, fence);
    static const auto wait = original<PFN_vkQueueWaitIdle>("vkQueueWaitIdle");
    wait(queue);  // nothing of this device is at work when it is torn down
    lost = true;
    return VK_SUCCESS;
}

VKAPI_ATTR VkResult VKAPI_CALL vkWaitForFences(VkDevice device, uint32_t count,
                                               const VkFence* fences, VkBool32 all,
                                               uint64_t nanoseconds) {
    static const auto next = original<PFN_vkWaitForFences>("vkWaitForFences");
    return lost ? VK_ERROR_DEVICE_LOST : next(device, count, fences, all, nanoseconds);
}

VKAPI_ATTR VkResult VKAPI_CALL vkDeviceWaitIdle(VkDevice device) {
    static const auto next = original<PFN_vkDeviceWaitIdle>("vkDeviceWaitIdle");
    return lost ? VK_ERROR_DEVICE_LOST : next(device);
}

VKAPI_ATTR VkResult VKAPI_CALL vkQueuePresentKHR(VkQueue queue, const VkPresentInfoKHR* info) {
    static const auto next = original<PFN_vkQueuePresentKHR>("vkQueuePresentKHR");
    return lost ? VK_ERROR_DEVICE_LOST : next(queue, info);
}

VKAPI_ATTR VkResult VKAPI_CALL vkAcquireNextImageKHR(VkDevice device, VkSwapchainKHR swapchain,
                                                     uint64_t nanoseconds, VkSemaphore semaphore,
                                                     VkFence fence, uint32_t* image) {
    static const auto next = original<PFN_vkAcquireNextImageKHR>("vkAcquireNextImageKHR");
    return lost ? VK_ERROR_DEVICE_LOST
                : next(device, swapchain, nanoseconds, semaphore, fence, image);
}

VKAPI_ATTR VkResult VKAPI_CALL vkGetQueryPoolResults(VkDevice device, VkQueryPool pool,
                                                     uint32_t first, uint32_t count, size_t bytes,
                                                     void* data, VkDeviceSize stride,
                                                     VkQueryResultFlags flags) {
    static const auto next = original<PFN_vkGetQueryPoolResults>("vkGetQueryPoolResults");
    return lost ? VK_ERROR_DEVICE_LOST
                : next(device, pool, first, count, bytes, data, stride, flags);
}

}  // extern "C"
