/// \file Recording commands and handing them to the queue.
#pragma once

#include <vulkan/vulkan.h>

#include <string>

#include "core/result.h"
#include "gpu/device.h"
#include "gpu/handle.h"
#include "gpu/sync.h"

namespace lampyris::gpu {

/// One command buffer with a pool of its own, recorded again and again.
class Commands {
 public:
    Commands() = default;
    static core::Result<Commands> create(Device& device, const std::string& name);

    /// Forgets what was recorded (the device must be done with it) and begins anew.
    core::Result<VkCommandBuffer> begin();
    core::Result<void> end();
    [[nodiscard]] VkCommandBuffer get() const { return buffer_; }

 private:
    Handle<VkCommandPool, vkDestroyCommandPool> pool_;
    VkCommandBuffer buffer_ = VK_NULL_HANDLE;
};

/// A name for what is recorded while this lives, for debuggers and for what the validation layer
/// says meanwhile. One at a time.
class Label {
 public:
    Label(const Device& device, VkCommandBuffer commands, const std::string& name);
    ~Label();
    Label(const Label&) = delete;
    Label& operator=(const Label&) = delete;

 private:
    const Device& device_;
    VkCommandBuffer commands_;
};

struct SubmitOptions {
    VkSemaphore wait = VK_NULL_HANDLE;
    VkPipelineStageFlags2 waitStages = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    VkSemaphore signal = VK_NULL_HANDLE;
    VkFence fence = VK_NULL_HANDLE;
};

core::Result<void> submit(Device& device, const Commands& commands, const SubmitOptions& options);

/// Submits and waits until the device is done.
core::Result<void> submitAndWait(Device& device, const Commands& commands);

/// Everything before is done and seen before anything after begins.
void fullBarrier(VkCommandBuffer commands);

}  // namespace lampyris::gpu
