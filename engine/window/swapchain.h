/// \file The images that a window shows in turn.
#pragma once

#include <vulkan/vulkan.h>

#include <vector>

#include "core/result.h"
#include "gpu/device.h"
#include "gpu/sync.h"

namespace lampyris::window {

/// How the source of a present holds its colours.
enum class Encoding : uint8_t {
    Linear,   ///< linear radiance: the swapchain clips it and encodes it as sRGB
    Display,  ///< already encoded: shown as it is
};

class Swapchain {
 public:
    Swapchain() = default;
    Swapchain(Swapchain&&) noexcept;
    Swapchain& operator=(Swapchain&& other) noexcept;
    ~Swapchain();

    /// An Error names what the device cannot do on this surface. `old` is retired.
    static core::Result<Swapchain> create(gpu::Device& device, VkSurfaceKHR surface,
                                          VkExtent2D size, Encoding encoding, VkSwapchainKHR old);

    struct Image {
        VkImage image = VK_NULL_HANDLE;
        VkImageView view = VK_NULL_HANDLE;
        VkSemaphore rendered = VK_NULL_HANDLE;  ///< signalled when it may be shown
    };
    [[nodiscard]] VkSwapchainKHR get() const { return swapchain_; }
    [[nodiscard]] const Image& image(uint32_t index) const { return images_[index]; }
    [[nodiscard]] VkExtent2D extent() const { return extent_; }
    [[nodiscard]] VkFormat format() const { return format_; }
    [[nodiscard]] uint32_t imageCount() const { return static_cast<uint32_t>(images_.size()); }

 private:
    core::Result<void> takeImages(gpu::Device& device);
    VkDevice device_ = VK_NULL_HANDLE;
    VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
    VkExtent2D extent_{};
    VkFormat format_ = VK_FORMAT_UNDEFINED;
    std::vector<Image> images_;
    std::vector<gpu::Handle<VkImageView, vkDestroyImageView>> views_;
    std::vector<gpu::Semaphore> semaphores_;
};

}  // namespace lampyris::window
