#include "gpu/compute_pipeline.h"

#include <cstddef>
#include <vector>

#include "gpu/vulkan_result.h"
#include "gpu/vulkan_struct.h"

namespace lampyris::gpu {

core::Result<Pipeline> createComputePipeline(Device& device,
                                             const ComputePipelineOptions& options) {
    std::vector<VkSpecializationMapEntry> entries;
    for (size_t i = 0; i < options.specialisation.size(); ++i)
        entries.push_back({options.specialisation[i].id,
                           static_cast<uint32_t>(i * sizeof(SpecialisationValue) +
                                                 offsetof(SpecialisationValue, value)),
                           sizeof(uint32_t)});
    VkSpecializationInfo specialisation{};
    specialisation.mapEntryCount = static_cast<uint32_t>(entries.size());
    specialisation.pMapEntries = entries.data();
    specialisation.dataSize = options.specialisation.size_bytes();
    specialisation.pData = options.specialisation.data();
    auto info =
        vulkanStruct<VkComputePipelineCreateInfo>(VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO);
    info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = options.module;
    info.stage.pName = "main";
    info.stage.pSpecializationInfo = entries.empty() ? nullptr : &specialisation;
    info.layout = options.layout;
    VkPipeline object = VK_NULL_HANDLE;
    VK_TRY(vkCreateComputePipelines(device.get(), device.pipelineCache().get(), 1, &info, nullptr,
                                    &object));
    setName(device, VK_OBJECT_TYPE_PIPELINE, object, options.name);
    return Pipeline{device.get(), object};
}

}  // namespace lampyris::gpu
