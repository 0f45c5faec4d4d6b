/// \file A Vulkan object that is destroyed with its owner. Move-only; empty after a move.
#pragma once

#include <vulkan/vulkan.h>

#include <utility>

namespace lampyris::gpu {

/// Owns one child object of a VkDevice. `Destroy` is its vkDestroy function.
template <typename T, auto Destroy>
class Handle {
 public:
    Handle() = default;
    Handle(VkDevice device, T object) : device_(device), object_(object) {}
    Handle(Handle&& other) noexcept
        : device_(other.device_), object_(std::exchange(other.object_, VK_NULL_HANDLE)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(device_, other.device_);
        std::swap(object_, other.object_);
        return *this;
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() {
        if (object_ != VK_NULL_HANDLE) Destroy(device_, object_, nullptr);
    }

    [[nodiscard]] T get() const { return object_; }
    [[nodiscard]] VkDevice device() const { return device_; }
    explicit operator bool() const { return object_ != VK_NULL_HANDLE; }

 private:
    VkDevice device_ = VK_NULL_HANDLE;
    T object_ = VK_NULL_HANDLE;
};

}  // namespace lampyris::gpu
