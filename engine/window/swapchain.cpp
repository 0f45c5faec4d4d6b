#include "window/swapchain.h"

#include <algorithm>
#include <array>
#include <utility>

#include "gpu/vulkan_result.h"
#include "gpu/vulkan_struct.h"

namespace lampyris::window {
namespace {

core::Result<VkSurfaceFormatKHR> chooseFormat(const gpu::Device& device, VkSurfaceKHR surface,
                                              Encoding encoding) {
    uint32_t count = 0;
    VK_TRY(vkGetPhysicalDeviceSurfaceFormatsKHR(device.physical(), surface, &count, nullptr));
    std::vector<VkSurfaceFormatKHR> formats(count);
    VK_TRY(
        vkGetPhysicalDeviceSurfaceFormatsKHR(device.physical(), surface, &count, formats.data()));
    const std::array wanted = encoding == Encoding::Linear
                                  ? std::array{VK_FORMAT_B8G8R8A8_SRGB, VK_FORMAT_R8G8B8A8_SRGB}
                                  : std::array{VK_FORMAT_B8G8R8A8_UNORM, VK_FORMAT_R8G8B8A8_UNORM};
    for (const VkFormat format : wanted)
        for (const VkSurfaceFormatKHR& offered : formats) {
            VkFormatProperties properties{};
            vkGetPhysicalDeviceFormatProperties(device.physical(), offered.format, &properties);
            const bool blits =
                (properties.optimalTilingFeatures & VK_FORMAT_FEATURE_BLIT_DST_BIT) != 0;
            if (offered.format == format && blits) return offered;
        }
    return core::error("{}: its windows have no 8-bit {} format that can be blitted to",
                       device.info().name, encoding == Encoding::Linear ? "sRGB" : "unorm");
}

core::Result<void> checkPresentable(const gpu::Device& device, VkSurfaceKHR surface) {
    VkBool32 supported = VK_FALSE;
    VK_TRY(vkGetPhysicalDeviceSurfaceSupportKHR(device.physical(), device.queueFamily(), surface,
                                                &supported));
    if (supported == VK_TRUE) return {};
    return core::error("{}: cannot present to this window", device.info().name);
}

VkExtent2D chooseExtent(const VkSurfaceCapabilitiesKHR& capabilities, VkExtent2D size) {
    if (capabilities.currentExtent.width != UINT32_MAX) return capabilities.currentExtent;
    return {std::clamp(size.width, capabilities.minImageExtent.width,
                       capabilities.maxImageExtent.width),
            std::clamp(size.height, capabilities.minImageExtent.height,
                       capabilities.maxImageExtent.height)};
}

}  // namespace

Swapchain::Swapchain(Swapchain&& other) noexcept {
    *this = std::move(other);
}

Swapchain& Swapchain::operator=(Swapchain&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(swapchain_, other.swapchain_);
    std::swap(extent_, other.extent_);
    std::swap(format_, other.format_);
    std::swap(images_, other.images_);
    std::swap(views_, other.views_);
    std::swap(semaphores_, other.semaphores_);
    return *this;
}

Swapchain::~Swapchain() {
    views_.clear();
    if (swapchain_ != VK_NULL_HANDLE) vkDestroySwapchainKHR(device_, swapchain_, nullptr);
}

core::Result<Swapchain> Swapchain::create(gpu::Device& device, VkSurfaceKHR surface,
                                          VkExtent2D size, Encoding encoding, VkSwapchainKHR old) {
    TRY_VOID(checkPresentable(device, surface));
    TRY(const VkSurfaceFormatKHR format, chooseFormat(device, surface, encoding));
    VkSurfaceCapabilitiesKHR capabilities{};
    VK_TRY(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device.physical(), surface, &capabilities));
    const uint32_t most = capabilities.maxImageCount == 0 ? UINT32_MAX : capabilities.maxImageCount;
    Swapchain swapchain;
    swapchain.device_ = device.get();
    swapchain.extent_ = chooseExtent(capabilities, size);
    swapchain.format_ = format.format;
    auto info =
        gpu::vulkanStruct<VkSwapchainCreateInfoKHR>(VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR);
    info.surface = surface;
    info.minImageCount = std::min(std::max(capabilities.minImageCount, 3u), most);
    info.imageFormat = format.format;
    info.imageColorSpace = format.colorSpace;
    info.imageExtent = swapchain.extent_;
    info.imageArrayLayers = 1;
    info.imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    info.imageSharingMode = VK_SHARING_MODE_EXCLUSIVE;
    info.preTransform = capabilities.currentTransform;
    info.compositeAlpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR;
    info.presentMode = VK_PRESENT_MODE_FIFO_KHR;
    info.clipped = VK_TRUE;
    info.oldSwapchain = old;
    VK_TRY(vkCreateSwapchainKHR(device.get(), &info, nullptr, &swapchain.swapchain_));
    gpu::setName(device, VK_OBJECT_TYPE_SWAPCHAIN_KHR, swapchain.swapchain_, "swapchain");
    TRY_VOID(swapchain.takeImages(device));
    return swapchain;
}

core::Result<void> Swapchain::takeImages(gpu::Device& device) {
    uint32_t count = 0;
    VK_TRY(vkGetSwapchainImagesKHR(device_, swapchain_, &count, nullptr));
    std::vector<VkImage> images(count);
    VK_TRY(vkGetSwapchainImagesKHR(device_, swapchain_, &count, images.data()));
    for (VkImage image : images) {
        gpu::setName(device, VK_OBJECT_TYPE_IMAGE, image, "swapchain image");
        auto info =
            gpu::vulkanStruct<VkImageViewCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO);
        info.image = image;
        info.viewType = VK_IMAGE_VIEW_TYPE_2D;
        info.format = format_;
        info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        VkImageView view = VK_NULL_HANDLE;
        VK_TRY(vkCreateImageView(device_, &info, nullptr, &view));
        views_.emplace_back(device_, view);
        gpu::setName(device, VK_OBJECT_TYPE_IMAGE_VIEW, view, "swapchain view");
        TRY(gpu::Semaphore rendered, gpu::createSemaphore(device, "image rendered"));
        images_.push_back({image, view, rendered.get()});
        semaphores_.push_back(std::move(rendered));
    }
    return {};
}

}  // namespace lampyris::window
