#include "gpu/sampler.h"

#include "gpu/vulkan_result.h"
#include "gpu/vulkan_struct.h"

namespace lampyris::gpu {

core::Result<Sampler> createSampler(const Device& device, const SamplerOptions& options) {
    const VkSamplerAddressMode addressing =
        options.repeat ? VK_SAMPLER_ADDRESS_MODE_REPEAT : VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    auto info = vulkanStruct<VkSamplerCreateInfo>(VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO);
    info.magFilter = options.linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
    info.minFilter = info.magFilter;
    info.mipmapMode = VK_SAMPLER_MIPMAP_MODE_NEAREST;
    info.addressModeU = addressing;
    info.addressModeV = addressing;
    info.addressModeW = addressing;
    VkSampler object = VK_NULL_HANDLE;
    VK_TRY(vkCreateSampler(device.get(), &info, nullptr, &object));
    setName(device, VK_OBJECT_TYPE_SAMPLER, object,
            fmt::format("sampler {} {}", options.linear ? "linear" : "nearest",
                        options.repeat ? "repeat" : "clamp"));
    return Sampler{device.get(), object};
}

}  // namespace lampyris::gpu
