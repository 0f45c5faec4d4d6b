/// \file Samplers: nearest or linear, clamped or repeated.
#pragma once

#include <vulkan/vulkan.h>

#include "core/result.h"
#include "gpu/device.h"
#include "gpu/handle.h"

namespace lampyris::gpu {

struct SamplerOptions {
    bool linear = false;
    bool repeat = false;
};

using Sampler = Handle<VkSampler, vkDestroySampler>;

core::Result<Sampler> createSampler(const Device& device, const SamplerOptions& options);

}  // namespace lampyris::gpu
