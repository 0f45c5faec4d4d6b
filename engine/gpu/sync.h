/// \file Fences and semaphores.
#pragma once

#include <vulkan/vulkan.h>

#include <string>

#include "core/result.h"
#include "gpu/device.h"
#include "gpu/handle.h"

namespace lampyris::gpu {

using Fence = Handle<VkFence, vkDestroyFence>;
using Semaphore = Handle<VkSemaphore, vkDestroySemaphore>;

core::Result<Fence> createFence(const Device& device, bool signalled, const std::string& name);
core::Result<Semaphore> createSemaphore(const Device& device, const std::string& name);

/// Waits for the fence and resets it.
core::Result<void> waitAndReset(const Device& device, const Fence& fence);

}  // namespace lampyris::gpu
