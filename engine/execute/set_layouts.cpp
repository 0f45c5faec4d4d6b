#include "execute/set_layouts.h"

#include <algorithm>
#include <map>

#include "execute/translate.h"

namespace lampyris::execute {
namespace {

using graph::SlotKind;

/// Vulkan guarantees few descriptors a stage (4 storage buffers, 4 storage images).
core::Result<void> checkSlotCounts(const gpu::Device& device, const graph::Shader& shader) {
    const VkPhysicalDeviceLimits& limits = device.limits().core;
    const auto count = [&](SlotKind first, SlotKind second) {
        return std::count_if(shader.slots.begin(), shader.slots.end(),
                             [&](const graph::ShaderSlot& slot) {
                                 return slot.kind == first || slot.kind == second;
                             });
    };
    struct Check {
        const char* limit;
        int64_t used;
        uint32_t most;
    };
    for (const Check& check :
         {Check{"maxPerStageDescriptorStorageBuffers",
                count(SlotKind::StorageBuffer, SlotKind::StorageBuffer),
                limits.maxPerStageDescriptorStorageBuffers},
          Check{"maxPerStageDescriptorUniformBuffers",
                count(SlotKind::UniformBuffer, SlotKind::UniformBuffer),
                limits.maxPerStageDescriptorUniformBuffers},
          Check{"maxPerStageDescriptorSampledImages",
                count(SlotKind::SampledImage, SlotKind::UniformTexelBuffer),
                limits.maxPerStageDescriptorSampledImages},
          Check{"maxPerStageDescriptorStorageImages",
                count(SlotKind::StorageImage, SlotKind::StorageTexelBuffer),
                limits.maxPerStageDescriptorStorageImages},
          Check{"maxPerStageResources", static_cast<int64_t>(shader.slots.size()),
                limits.maxPerStageResources}})
        if (check.used > check.most)
            return core::error("shader {}: {} slots are more than the device's {}, {}", shader.name,
                               check.used, check.limit, check.most);
    return {};
}

struct MergedSlot {
    graph::ShaderSlot slot;
    VkShaderStageFlags stages = 0;
};

core::Result<std::map<uint32_t, MergedSlot>> mergeSlots(std::span<const StageShader> stages) {
    std::map<uint32_t, MergedSlot> merged;
    for (const StageShader& stage : stages)
        for (const graph::ShaderSlot& slot : stage.shader->slots) {
            MergedSlot& place = merged.try_emplace(slot.slot, MergedSlot{slot, 0}).first->second;
            if (place.slot.kind != slot.kind)
                return core::error("shader {}: slot {} ({}) is of another kind in the other stage",
                                   stage.shader->name, slot.slot, slot.name);
            place.stages |= stage.stage;
        }
    return merged;
}

}  // namespace

core::Result<SetLayout> makeSetLayout(const gpu::Device& device,
                                      std::span<const StageShader> stages) {
    const std::string name{stages.front().shader->name};
    SetLayout layout;
    for (const StageShader& stage : stages) {
        TRY_VOID(checkSlotCounts(device, *stage.shader));
        if (stage.stage != VK_SHADER_STAGE_COMPUTE_BIT)
            layout.bindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
        if (stage.shader->pushConstantBytes == 0) continue;
        layout.pushStages |= stage.stage;
        // A multiple of 4, as ranges must be.
        layout.pushBytes = std::max(layout.pushBytes, (stage.shader->pushConstantBytes + 3) & ~3u);
    }
    TRY(const auto merged, mergeSlots(stages));
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (const auto& [number, entry] : merged) {
        layout.slots.push_back(entry.slot);
        bindings.push_back({number, descriptorTypeOf(entry.slot.kind), 1, entry.stages, nullptr});
    }
    TRY(layout.set, gpu::createDescriptorLayout(device, bindings, name));
    TRY(layout.pipeline, gpu::createPipelineLayout(device, layout.set.get(), layout.pushBytes,
                                                   layout.pushStages, name));
    return layout;
}

}  // namespace lampyris::execute
