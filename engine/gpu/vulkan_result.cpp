#include "gpu/vulkan_result.h"

namespace lampyris::gpu {

const char* resultName(VkResult result) {
#define LAMPYRIS_CASE(name) \
    case name:              \
        return #name
    switch (result) {
        LAMPYRIS_CASE(VK_SUCCESS);
        LAMPYRIS_CASE(VK_NOT_READY);
        LAMPYRIS_CASE(VK_TIMEOUT);
        LAMPYRIS_CASE(VK_INCOMPLETE);
        LAMPYRIS_CASE(VK_SUBOPTIMAL_KHR);
        LAMPYRIS_CASE(VK_ERROR_OUT_OF_HOST_MEMORY);
        LAMPYRIS_CASE(VK_ERROR_OUT_OF_DEVICE_MEMORY);
        LAMPYRIS_CASE(VK_ERROR_INITIALIZATION_FAILED);
        LAMPYRIS_CASE(VK_ERROR_DEVICE_LOST);
        LAMPYRIS_CASE(VK_ERROR_MEMORY_MAP_FAILED);
        LAMPYRIS_CASE(VK_ERROR_LAYER_NOT_PRESENT);
        LAMPYRIS_CASE(VK_ERROR_EXTENSION_NOT_PRESENT);
        LAMPYRIS_CASE(VK_ERROR_FEATURE_NOT_PRESENT);
        LAMPYRIS_CASE(VK_ERROR_INCOMPATIBLE_DRIVER);
        LAMPYRIS_CASE(VK_ERROR_TOO_MANY_OBJECTS);
        LAMPYRIS_CASE(VK_ERROR_FORMAT_NOT_SUPPORTED);
        LAMPYRIS_CASE(VK_ERROR_FRAGMENTED_POOL);
        LAMPYRIS_CASE(VK_ERROR_OUT_OF_POOL_MEMORY);
        LAMPYRIS_CASE(VK_ERROR_SURFACE_LOST_KHR);
        LAMPYRIS_CASE(VK_ERROR_NATIVE_WINDOW_IN_USE_KHR);
        LAMPYRIS_CASE(VK_ERROR_OUT_OF_DATE_KHR);
        default:
            return "an unknown VkResult";
    }
#undef LAMPYRIS_CASE
}

core::Error vulkanError(VkResult result, std::string_view call) {
    return core::error("{}: {}", call.substr(0, call.find('(')), resultName(result));
}

}  // namespace lampyris::gpu
