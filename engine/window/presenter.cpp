#include "window/presenter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gpu/vulkan_result.h"
#include "gpu/vulkan_struct.h"

namespace lampyris::window {
namespace {

// [chosen] A window that was destroyed never gives an image back; a compositor takes milliseconds.
constexpr uint64_t kAcquireNanoseconds = 500'000'000;

void changeLayout(VkCommandBuffer commands, VkImage image, VkImageLayout before,
                  VkImageLayout after) {
    auto barrier =
        gpu::vulkanStruct<VkImageMemoryBarrier2>(VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2);
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.oldLayout = before;
    barrier.newLayout = after;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    auto dependency = gpu::vulkanStruct<VkDependencyInfo>(VK_STRUCTURE_TYPE_DEPENDENCY_INFO);
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

void blitFitted(VkCommandBuffer commands, const gpu::Image& source, VkImage target,
                VkExtent2D window) {
    const VkImageSubresourceRange whole{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    const VkClearColorValue black{{0.0f, 0.0f, 0.0f, 1.0f}};
    vkCmdClearColorImage(commands, target, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &black, 1, &whole);
    gpu::fullBarrier(commands);
    const VkExtent2D picture = source.options().extent;
    const VkRect2D place = fitted(picture, window);
    VkImageBlit region{};
    region.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.srcOffsets[1] = {static_cast<int32_t>(picture.width),
                            static_cast<int32_t>(picture.height), 1};
    region.dstSubresource = region.srcSubresource;
    region.dstOffsets[0] = {place.offset.x, place.offset.y, 0};
    region.dstOffsets[1] = {place.offset.x + static_cast<int32_t>(place.extent.width),
                            place.offset.y + static_cast<int32_t>(place.extent.height), 1};
    const bool scaled =
        place.extent.width != picture.width || place.extent.height != picture.height;
    vkCmdBlitImage(commands, source.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, target,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region,
                   scaled ? VK_FILTER_LINEAR : VK_FILTER_NEAREST);
}

}  // namespace

VkRect2D fitted(VkExtent2D picture, VkExtent2D window) {
    const double scale = std::min(static_cast<double>(window.width) / picture.width,
                                  static_cast<double>(window.height) / picture.height);
    const auto scaled = [&](uint32_t side, uint32_t most) {
        return std::clamp(static_cast<uint32_t>(std::lround(side * scale)), 1u, most);
    };
    const VkExtent2D size{scaled(picture.width, window.width),
                          scaled(picture.height, window.height)};
    return {{static_cast<int32_t>((window.width - size.width) / 2),
             static_cast<int32_t>((window.height - size.height) / 2)},
            size};
}

core::Result<Presenter> Presenter::create(gpu::Device& device, Window& window, Encoding encoding) {
    if (!device.presentable())
        return core::error("{}: was not made to show images in a window ({})", device.info().name,
                           VK_KHR_SWAPCHAIN_EXTENSION_NAME);
    Presenter presenter{device, window, encoding};
    TRY(presenter.surface_, window.createSurface(device.instance()));
    for (Slot& slot : presenter.slots_) {
        TRY(slot.commands, gpu::Commands::create(device, "present"));
        TRY(slot.fence, gpu::createFence(device, false, "present"));
        TRY(slot.acquired, gpu::createSemaphore(device, "image acquired"));
    }
    TRY_VOID(presenter.renewSwapchain());
    return presenter;
}

Presenter::Presenter(Presenter&& other) noexcept
    : device_(other.device_),
      window_(other.window_),
      encoding_(other.encoding_),
      surface_(std::exchange(other.surface_, VK_NULL_HANDLE)),
      swapchain_(std::move(other.swapchain_)),
      slots_(std::move(other.slots_)),
      next_(other.next_),
      stale_(other.stale_) {}

Presenter& Presenter::operator=(Presenter&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(window_, other.window_);
    std::swap(encoding_, other.encoding_);
    std::swap(surface_, other.surface_);
    std::swap(swapchain_, other.swapchain_);
    std::swap(slots_, other.slots_);
    std::swap(next_, other.next_);
    std::swap(stale_, other.stale_);
    return *this;
}

Presenter::~Presenter() {
    if (surface_ == VK_NULL_HANDLE) return;
    device_->settle();
    swapchain_ = {};
    vkDestroySurfaceKHR(device_->instance(), surface_, nullptr);
}

core::Result<void> Presenter::renewSwapchain() {
    const VkExtent2D size = window_->framebufferSize();
    stale_ = true;
    if (size.width == 0 || size.height == 0) return {};
    TRY_VOID(device_->waitIdle());
    TRY(swapchain_, Swapchain::create(*device_, surface_, size, encoding_, swapchain_.get()));
    stale_ = false;
    return {};
}

core::Result<Presented> Presenter::present(const gpu::Image& source,
                                           const std::function<void(const Canvas&)>& draw) {
    if (window_->shouldClose()) return Presented::Closed;
    const VkExtent2D size = window_->framebufferSize();
    if (size.width == 0 || size.height == 0) return skipped();
    if (size.width != swapchain_.extent().width || size.height != swapchain_.extent().height)
        stale_ = true;
    if (stale_) TRY_VOID(renewSwapchain());
    if (stale_) return skipped();  // no size any more
    Slot& slot = slots_[next_];
    if (slot.pending) TRY_VOID(gpu::waitAndReset(*device_, slot.fence));
    slot.pending = false;
    uint32_t image = 0;
    TRY(const VkResult acquired, acquire(slot, image));
    if (acquired == VK_ERROR_SURFACE_LOST_KHR) return Presented::Closed;
    if (acquired != VK_SUCCESS) return Presented::Skipped;
    TRY_VOID(record(slot, source, image, draw));
    TRY_VOID(gpu::submit(*device_, slot.commands,
                         {.wait = slot.acquired.get(),
                          .signal = swapchain_.image(image).rendered,
                          .fence = slot.fence.get()}));
    slot.pending = true;
    next_ = (next_ + 1) % slots_.size();
    return show(image);
}

Presented Presenter::skipped() const {
    // That the window was destroyed may be known only since its size was asked for.
    return window_->shouldClose() ? Presented::Closed : Presented::Skipped;
}

core::Result<VkResult> Presenter::acquire(Slot& slot, uint32_t& image) {
    const VkResult result =
        vkAcquireNextImageKHR(device_->get(), swapchain_.get(), kAcquireNanoseconds,
                              slot.acquired.get(), VK_NULL_HANDLE, &image);
    switch (result) {
        case VK_SUBOPTIMAL_KHR:  // acquired all the same
            stale_ = true;
            return VK_SUCCESS;
        case VK_ERROR_OUT_OF_DATE_KHR:
            stale_ = true;
            return result;
        case VK_SUCCESS:
        case VK_TIMEOUT:
        case VK_ERROR_SURFACE_LOST_KHR:
            return result;
        default:
            return gpu::vulkanError(result, "vkAcquireNextImageKHR");
    }
}

core::Result<void> Presenter::record(Slot& slot, const gpu::Image& source, uint32_t image,
                                     const std::function<void(const Canvas&)>& draw) {
    TRY(const VkCommandBuffer commands, slot.commands.begin());
    const Swapchain::Image& target = swapchain_.image(image);
    VkImageLayout layout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    changeLayout(commands, target.image, VK_IMAGE_LAYOUT_UNDEFINED, layout);
    blitFitted(commands, source, target.image, swapchain_.extent());
    if (draw) {
        changeLayout(commands, target.image, layout, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
        layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
        draw({commands, target.view, swapchain_.format(), swapchain_.extent()});
    }
    changeLayout(commands, target.image, layout, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR);
    return slot.commands.end();
}

core::Result<Presented> Presenter::show(uint32_t image) {
    const VkSwapchainKHR swapchain = swapchain_.get();
    auto info = gpu::vulkanStruct<VkPresentInfoKHR>(VK_STRUCTURE_TYPE_PRESENT_INFO_KHR);
    info.waitSemaphoreCount = 1;
    info.pWaitSemaphores = &swapchain_.image(image).rendered;
    info.swapchainCount = 1;
    info.pSwapchains = &swapchain;
    info.pImageIndices = &image;
    const VkResult result = vkQueuePresentKHR(device_->queue(), &info);
    if (result == VK_SUBOPTIMAL_KHR || result == VK_ERROR_OUT_OF_DATE_KHR) stale_ = true;
    if (result == VK_ERROR_SURFACE_LOST_KHR) return Presented::Closed;
    if (result == VK_SUCCESS || result == VK_SUBOPTIMAL_KHR) return Presented::Shown;
    if (result == VK_ERROR_OUT_OF_DATE_KHR) return Presented::Skipped;
    return gpu::vulkanError(result, "vkQueuePresentKHR");
}

}  // namespace lampyris::window
