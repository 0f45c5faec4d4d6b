/// \file From VkResult to Error. No result of Vulkan's is ignored.
#pragma once

#include <vulkan/vulkan.h>

#include <string_view>

#include "core/result.h"

namespace lampyris::gpu {

/// "VK_ERROR_DEVICE_LOST" and the like.
[[nodiscard]] const char* resultName(VkResult result);

/// "vkQueueSubmit2: VK_ERROR_DEVICE_LOST"; `call` may be the whole expression, its name is kept.
[[nodiscard]] core::Error vulkanError(VkResult result, std::string_view call);

}  // namespace lampyris::gpu

/// Goes on where the call gave VK_SUCCESS, or returns an Error that names call and result.
#define VK_TRY(call)                                                                            \
    do {                                                                                        \
        const VkResult vkTryResult = (call);                                                    \
        if (vkTryResult != VK_SUCCESS) return ::lampyris::gpu::vulkanError(vkTryResult, #call); \
    } while (false)
