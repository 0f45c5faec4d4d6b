#include "gpu/image.h"

#include <algorithm>

#include "gpu/vulkan_result.h"
#include "gpu/vulkan_struct.h"

namespace lampyris::gpu {
namespace {

VkImageCreateInfo createInfo(const ImageOptions& options) {
    auto info = vulkanStruct<VkImageCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO);
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = options.format;
    info.extent = {options.extent.width, options.extent.height, 1};
    info.mipLevels = 1;
    info.arrayLayers = options.layers;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = options.usage;
    info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
    info.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    return info;
}

core::Result<void> checkFormat(const Device& device, const ImageOptions& options) {
    VkImageFormatProperties properties{};
    const VkResult result = vkGetPhysicalDeviceImageFormatProperties(
        device.physical(), options.format, VK_IMAGE_TYPE_2D, VK_IMAGE_TILING_OPTIMAL, options.usage,
        0, &properties);
    if (result == VK_SUCCESS) return {};
    return core::error("image {}: VkFormat {} cannot be used as usage {:#x} asks ({})",
                       options.name, static_cast<int>(options.format), options.usage,
                       resultName(result));
}

core::Result<void> checkLimits(const Device& device, const ImageOptions& options) {
    const VkPhysicalDeviceLimits& limits = device.limits().core;
    const uint32_t side = std::max(options.extent.width, options.extent.height);
    if (side > limits.maxImageDimension2D)
        return core::error("image {}: {} x {} is more than the device's maxImageDimension2D, {}",
                           options.name, options.extent.width, options.extent.height,
                           limits.maxImageDimension2D);
    if (options.layers > limits.maxImageArrayLayers)
        return core::error("image {}: {} layers are more than the device's maxImageArrayLayers, {}",
                           options.name, options.layers, limits.maxImageArrayLayers);
    return {};
}

}  // namespace

Image& Image::operator=(Image&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(memory_, other.memory_);
    std::swap(image_, other.image_);
    std::swap(view_, other.view_);
    std::swap(options_, other.options_);
    return *this;
}

core::Result<Image> Image::createUnbound(Device& device, const ImageOptions& options) {
    TRY_VOID(checkLimits(device, options));
    TRY_VOID(checkFormat(device, options));
    Image image;
    image.device_ = &device;
    image.options_ = options;
    const VkImageCreateInfo info = createInfo(options);
    VkImage object = VK_NULL_HANDLE;
    VK_TRY(vkCreateImage(device.get(), &info, nullptr, &object));
    image.image_ = {device.get(), object};
    setName(device, VK_OBJECT_TYPE_IMAGE, object, options.name);
    return image;
}

core::Result<Image> Image::create(Device& device, const ImageOptions& options) {
    TRY(Image image, createUnbound(device, options));
    TRY(image.memory_, device.memory().allocate(image.memoryRequirements(), MemoryUse::Device,
                                                false, options.name.c_str()));
    VK_TRY(vkBindImageMemory(device.get(), image.get(), image.memory_.memory(),
                             image.memory_.offset()));
    TRY_VOID(image.makeView());
    return image;
}

core::Result<void> Image::bind(const Allocation& memory, uint64_t offset) {
    VK_TRY(vkBindImageMemory(device_->get(), get(), memory.memory(), memory.offset() + offset));
    return makeView();
}

core::Result<void> Image::makeView() {
    // Images that are only copied have no use for a view, and may not have one.
    constexpr VkImageUsageFlags kViewed = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT |
                                          VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT |
                                          VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
    if ((options_.usage & kViewed) == 0) return {};
    const bool array = options_.array || options_.layers > 1;
    auto info = vulkanStruct<VkImageViewCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO);
    info.image = get();
    info.viewType = array ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D;
    info.format = options_.format;
    info.subresourceRange = {aspect(), 0, 1, 0, options_.layers};
    VkImageView object = VK_NULL_HANDLE;
    VK_TRY(vkCreateImageView(device_->get(), &info, nullptr, &object));
    view_ = {device_->get(), object};
    setName(*device_, VK_OBJECT_TYPE_IMAGE_VIEW, object, options_.name);
    return {};
}

VkImageAspectFlags Image::aspect() const {
    return aspectOf(options_.format);
}

VkMemoryRequirements Image::memoryRequirements() const {
    VkMemoryRequirements needs{};
    vkGetImageMemoryRequirements(device_->get(), get(), &needs);
    return needs;
}

VkMemoryRequirements imageMemoryRequirements(const Device& device, const ImageOptions& options) {
    const VkImageCreateInfo info = createInfo(options);
    auto question = vulkanStruct<VkDeviceImageMemoryRequirements>(
        VK_STRUCTURE_TYPE_DEVICE_IMAGE_MEMORY_REQUIREMENTS);
    question.pCreateInfo = &info;
    auto answer = vulkanStruct<VkMemoryRequirements2>(VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2);
    vkGetDeviceImageMemoryRequirements(device.get(), &question, &answer);
    return answer.memoryRequirements;
}

VkImageAspectFlags aspectOf(VkFormat format) {
    const bool depth = format == VK_FORMAT_D32_SFLOAT || format == VK_FORMAT_D16_UNORM;
    return depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

}  // namespace lampyris::gpu
