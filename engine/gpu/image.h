/// \file Device images: 2D, or 2D arrays, one mip level, optimal tiling.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <string>

#include "core/result.h"
#include "gpu/device.h"
#include "gpu/handle.h"

namespace lampyris::gpu {

struct ImageOptions {
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkExtent2D extent{1, 1};
    uint32_t layers = 1;
    bool array = false;  ///< seen by shaders as an array even with one layer
    VkImageUsageFlags usage = 0;
    std::string name{};
};

class Image {
 public:
    Image() = default;
    Image(Image&&) noexcept = default;
    Image& operator=(Image&& other) noexcept;
    ~Image() = default;

    /// An Error names the image and, where one is in the way, the limit.
    static core::Result<Image> create(Device& device, const ImageOptions& options);
    /// An image without memory; bind() gives it some, and makes its view.
    static core::Result<Image> createUnbound(Device& device, const ImageOptions& options);
    /// Places it at `offset` bytes of memory that outlives it.
    core::Result<void> bind(const Allocation& memory, uint64_t offset);

    [[nodiscard]] VkImage get() const { return image_.get(); }
    /// All layers; a 2D array where there are several or `array` was set.
    [[nodiscard]] VkImageView view() const { return view_.get(); }
    [[nodiscard]] const ImageOptions& options() const { return options_; }
    [[nodiscard]] VkImageAspectFlags aspect() const;
    [[nodiscard]] VkMemoryRequirements memoryRequirements() const;

 private:
    core::Result<void> makeView();
    Device* device_ = nullptr;
    Allocation memory_;
    Handle<VkImage, vkDestroyImage> image_;
    Handle<VkImageView, vkDestroyImageView> view_;
    ImageOptions options_;
};

/// What such an image takes, without making one.
[[nodiscard]] VkMemoryRequirements imageMemoryRequirements(const Device& device,
                                                           const ImageOptions& options);

/// Depth for depth formats, else colour.
[[nodiscard]] VkImageAspectFlags aspectOf(VkFormat format);

}  // namespace lampyris::gpu
