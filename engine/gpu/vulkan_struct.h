/// \file Vulkan's structs, zeroed but for their type.
#pragma once

#include <vulkan/vulkan.h>

namespace lampyris::gpu {

template <typename T>
[[nodiscard]] T vulkanStruct(VkStructureType type, const void* next = nullptr) {
    T result{};
    result.sType = type;
    result.pNext = const_cast<void*>(next);
    return result;
}

}  // namespace lampyris::gpu
