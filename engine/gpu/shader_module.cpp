#include "gpu/shader_module.h"

#include "gpu/vulkan_result.h"
#include "gpu/vulkan_struct.h"

namespace lampyris::gpu {

core::Result<ShaderModule> createShaderModule(const Device& device, std::span<const uint32_t> words,
                                              const std::string& name) {
    auto info = vulkanStruct<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
    info.codeSize = words.size_bytes();
    info.pCode = words.data();
    VkShaderModule object = VK_NULL_HANDLE;
    VK_TRY(vkCreateShaderModule(device.get(), &info, nullptr, &object));
    setName(device, VK_OBJECT_TYPE_SHADER_MODULE, object, name);
    return ShaderModule{device.get(), object};
}

}  // namespace lampyris::gpu
