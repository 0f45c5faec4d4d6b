#include "gpu/raster_pipeline.h"

#include <array>
#include <vector>

#include "gpu/vulkan_result.h"
#include "gpu/vulkan_struct.h"

namespace lampyris::gpu {
namespace {

VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits bit, VkShaderModule module) {
    auto info = vulkanStruct<VkPipelineShaderStageCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO);
    info.stage = bit;
    info.module = module;
    info.pName = "main";
    return info;
}

/// What no option changes, and what few do. Not copyable: it points into itself.
struct FixedFunction {
    VkPipelineVertexInputStateCreateInfo vertices =
        vulkanStruct<VkPipelineVertexInputStateCreateInfo>(
            VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO);
    VkPipelineInputAssemblyStateCreateInfo assembly =
        vulkanStruct<VkPipelineInputAssemblyStateCreateInfo>(
            VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO);
    VkPipelineViewportStateCreateInfo viewport = vulkanStruct<VkPipelineViewportStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO);
    VkPipelineRasterizationStateCreateInfo raster =
        vulkanStruct<VkPipelineRasterizationStateCreateInfo>(
            VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO);
    VkPipelineMultisampleStateCreateInfo samples =
        vulkanStruct<VkPipelineMultisampleStateCreateInfo>(
            VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO);
    VkPipelineDepthStencilStateCreateInfo depth =
        vulkanStruct<VkPipelineDepthStencilStateCreateInfo>(
            VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO);
    std::vector<VkPipelineColorBlendAttachmentState> blends;
    VkPipelineColorBlendStateCreateInfo blend = vulkanStruct<VkPipelineColorBlendStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO);
    std::array<VkDynamicState, 2> dynamicStates{VK_DYNAMIC_STATE_VIEWPORT,
                                                VK_DYNAMIC_STATE_SCISSOR};
    VkPipelineDynamicStateCreateInfo dynamic = vulkanStruct<VkPipelineDynamicStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO);

    explicit FixedFunction(const RasterPipelineOptions& options) {
        vertices.vertexBindingDescriptionCount = static_cast<uint32_t>(options.streams.size());
        vertices.pVertexBindingDescriptions = options.streams.data();
        vertices.vertexAttributeDescriptionCount = static_cast<uint32_t>(options.attributes.size());
        vertices.pVertexAttributeDescriptions = options.attributes.data();
        assembly.topology =
            options.lines ? VK_PRIMITIVE_TOPOLOGY_LINE_LIST : VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
        viewport.viewportCount = 1;
        viewport.scissorCount = 1;
        raster.polygonMode = VK_POLYGON_MODE_FILL;
        raster.cullMode = VK_CULL_MODE_NONE;
        raster.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
        raster.lineWidth = 1.0f;
        samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
        const bool hasDepth = options.depth != VK_FORMAT_UNDEFINED;
        depth.depthTestEnable = hasDepth && options.depthTest ? VK_TRUE : VK_FALSE;
        depth.depthWriteEnable = hasDepth && options.depthWrite ? VK_TRUE : VK_FALSE;
        depth.depthCompareOp =
            options.depthEqual ? VK_COMPARE_OP_EQUAL : VK_COMPARE_OP_GREATER_OR_EQUAL;
        VkPipelineColorBlendAttachmentState writeAll{};
        writeAll.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                                  VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
        if (options.blend) {
            writeAll.blendEnable = VK_TRUE;
            writeAll.srcColorBlendFactor = VK_BLEND_FACTOR_SRC_ALPHA;
            writeAll.dstColorBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
            writeAll.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
            writeAll.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
        }
        blends.assign(options.colours.size(), writeAll);
        blend.attachmentCount = static_cast<uint32_t>(blends.size());
        blend.pAttachments = blends.data();
        dynamic.dynamicStateCount = static_cast<uint32_t>(dynamicStates.size());
        dynamic.pDynamicStates = dynamicStates.data();
    }
    FixedFunction(const FixedFunction&) = delete;
    FixedFunction& operator=(const FixedFunction&) = delete;
};

}  // namespace

core::Result<Pipeline> createRasterPipeline(Device& device, const RasterPipelineOptions& options) {
    std::vector stages{stage(VK_SHADER_STAGE_VERTEX_BIT, options.vertex)};
    if (options.fragment != VK_NULL_HANDLE)
        stages.push_back(stage(VK_SHADER_STAGE_FRAGMENT_BIT, options.fragment));
    const FixedFunction fixed{options};
    auto rendering = vulkanStruct<VkPipelineRenderingCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO);
    rendering.colorAttachmentCount = static_cast<uint32_t>(options.colours.size());
    rendering.pColorAttachmentFormats = options.colours.data();
    rendering.depthAttachmentFormat = options.depth;
    auto info = vulkanStruct<VkGraphicsPipelineCreateInfo>(
        VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO, &rendering);
    info.stageCount = static_cast<uint32_t>(stages.size());
    info.pStages = stages.data();
    info.pVertexInputState = &fixed.vertices;
    info.pInputAssemblyState = &fixed.assembly;
    info.pViewportState = &fixed.viewport;
    info.pRasterizationState = &fixed.raster;
    info.pMultisampleState = &fixed.samples;
    info.pDepthStencilState = &fixed.depth;
    info.pColorBlendState = &fixed.blend;
    info.pDynamicState = &fixed.dynamic;
    info.layout = options.layout;
    VkPipeline object = VK_NULL_HANDLE;
    VK_TRY(vkCreateGraphicsPipelines(device.get(), device.pipelineCache().get(), 1, &info, nullptr,
                                     &object));
    setName(device, VK_OBJECT_TYPE_PIPELINE, object, options.name);
    return Pipeline{device.get(), object};
}

}  // namespace lampyris::gpu
