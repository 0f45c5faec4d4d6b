/// \file Shows images of the device in a window.
#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <functional>

#include "core/result.h"
#include "gpu/commands.h"
#include "gpu/device.h"
#include "gpu/image.h"
#include "window/swapchain.h"
#include "window/window.h"

namespace lampyris::window {

enum class Presented : uint8_t {
    Shown,
    Skipped,  ///< minimised, or the window is just changing its size
    Closed,   ///< the window is gone
};

/// The swapchain image that is about to be shown, for who draws over it. It is in the layout
/// COLOR_ATTACHMENT_OPTIMAL and must be left in it.
struct Canvas {
    VkCommandBuffer commands = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkExtent2D extent{};
};

/// Where a picture of one size lies in a window of another: as large as fits, in the middle.
[[nodiscard]] VkRect2D fitted(VkExtent2D picture, VkExtent2D window);

class Presenter {
 public:
    /// The device and the window must outlive it. An Error where the device was made without
    /// DeviceOptions::presentable, or adopted without VK_KHR_swapchain. The instance of an adopted
    /// device must have been made with the extensions that GLFW names for the display
    /// (glfwGetRequiredInstanceExtensions: VK_KHR_surface and VK_KHR_xcb_surface or the like).
    static core::Result<Presenter> create(gpu::Device& device, Window& window, Encoding encoding);
    Presenter(Presenter&& other) noexcept;
    Presenter& operator=(Presenter&& other) noexcept;
    ~Presenter();

    /// Blits `source`, which is in the layout TRANSFER_SRC_OPTIMAL (where the executor leaves a
    /// transient output), into the window, lets `draw` draw over it, and shows it. Waits for none
    /// of it, but for the present before the last.
    core::Result<Presented> present(const gpu::Image& source,
                                    const std::function<void(const Canvas&)>& draw = {});
    [[nodiscard]] VkFormat format() const { return swapchain_.format(); }
    [[nodiscard]] uint32_t imageCount() const { return swapchain_.imageCount(); }

 private:
    struct Slot {
        gpu::Commands commands;
        gpu::Fence fence;
        gpu::Semaphore acquired;
        bool pending = false;
    };
    Presenter(gpu::Device& device, Window& window, Encoding encoding)
        : device_(&device), window_(&window), encoding_(encoding) {}
    core::Result<void> renewSwapchain();
    [[nodiscard]] Presented skipped() const;
    core::Result<VkResult> acquire(Slot& slot, uint32_t& image);
    core::Result<void> record(Slot& slot, const gpu::Image& source, uint32_t image,
                              const std::function<void(const Canvas&)>& draw);
    core::Result<Presented> show(uint32_t image);

    gpu::Device* device_;
    Window* window_;
    Encoding encoding_;
    VkSurfaceKHR surface_ = VK_NULL_HANDLE;
    Swapchain swapchain_;
    std::array<Slot, 2> slots_;
    size_t next_ = 0;
    bool stale_ = true;  ///< the swapchain must be made, or made anew
};

}  // namespace lampyris::window
