#include "gpu/descriptors.h"

#include <array>

#include "gpu/vulkan_result.h"
#include "gpu/vulkan_struct.h"

namespace lampyris::gpu {
namespace {

// [chosen] A frame has some tens of nodes, so that one pool serves most frames.
constexpr uint32_t kSetsPerPool = 64;
constexpr uint32_t kDescriptorsPerSet = 8;

}  // namespace

core::Result<DescriptorLayout> createDescriptorLayout(
    const Device& device, std::span<const VkDescriptorSetLayoutBinding> bindings,
    const std::string& name) {
    auto info = vulkanStruct<VkDescriptorSetLayoutCreateInfo>(
        VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
    info.bindingCount = static_cast<uint32_t>(bindings.size());
    info.pBindings = bindings.data();
    VkDescriptorSetLayout object = VK_NULL_HANDLE;
    VK_TRY(vkCreateDescriptorSetLayout(device.get(), &info, nullptr, &object));
    setName(device, VK_OBJECT_TYPE_DESCRIPTOR_SET_LAYOUT, object, name);
    return DescriptorLayout{device.get(), object};
}

core::Result<PipelineLayout> createPipelineLayout(const Device& device, VkDescriptorSetLayout set,
                                                  uint32_t pushBytes, VkShaderStageFlags pushStages,
                                                  const std::string& name) {
    if (pushBytes > device.limits().core.maxPushConstantsSize)
        return core::error(
            "{}: {} bytes of push constants are more than the device's "
            "maxPushConstantsSize, {}",
            name, pushBytes, device.limits().core.maxPushConstantsSize);
    const VkPushConstantRange range{pushStages, 0, pushBytes};
    auto info =
        vulkanStruct<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
    info.setLayoutCount = 1;
    info.pSetLayouts = &set;
    info.pushConstantRangeCount = pushBytes == 0 ? 0 : 1;
    info.pPushConstantRanges = &range;
    VkPipelineLayout object = VK_NULL_HANDLE;
    VK_TRY(vkCreatePipelineLayout(device.get(), &info, nullptr, &object));
    setName(device, VK_OBJECT_TYPE_PIPELINE_LAYOUT, object, name);
    return PipelineLayout{device.get(), object};
}

core::Result<void> DescriptorPool::grow() {
    constexpr std::array kTypes{
        VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,         VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
        VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER,   VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER,
        VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE};
    std::array<VkDescriptorPoolSize, kTypes.size()> sizes{};
    for (size_t i = 0; i < kTypes.size(); ++i)
        sizes[i] = {kTypes[i], kSetsPerPool * kDescriptorsPerSet};
    auto info =
        vulkanStruct<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
    info.maxSets = kSetsPerPool;
    info.poolSizeCount = static_cast<uint32_t>(sizes.size());
    info.pPoolSizes = sizes.data();
    VkDescriptorPool object = VK_NULL_HANDLE;
    VK_TRY(vkCreateDescriptorPool(device_->get(), &info, nullptr, &object));
    pools_.emplace_back(device_->get(), object);
    setName(*device_, VK_OBJECT_TYPE_DESCRIPTOR_POOL, object, "descriptor pool");
    return {};
}

core::Result<VkDescriptorSet> DescriptorPool::allocate(VkDescriptorSetLayout layout) {
    while (true) {
        const bool fresh = current_ == pools_.size();
        if (fresh) TRY_VOID(grow());
        auto info = vulkanStruct<VkDescriptorSetAllocateInfo>(
            VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
        info.descriptorPool = pools_[current_].get();
        info.descriptorSetCount = 1;
        info.pSetLayouts = &layout;
        VkDescriptorSet set = VK_NULL_HANDLE;
        const VkResult result = vkAllocateDescriptorSets(device_->get(), &info, &set);
        if (result == VK_SUCCESS) return set;
        const bool full =
            result == VK_ERROR_OUT_OF_POOL_MEMORY || result == VK_ERROR_FRAGMENTED_POOL;
        if (!full || fresh) return vulkanError(result, "vkAllocateDescriptorSets");
        ++current_;
    }
}

core::Result<void> DescriptorPool::reset() {
    for (const auto& pool : pools_) VK_TRY(vkResetDescriptorPool(device_->get(), pool.get(), 0));
    current_ = 0;
    return {};
}

}  // namespace lampyris::gpu
