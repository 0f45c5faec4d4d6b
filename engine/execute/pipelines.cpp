#include "execute/pipelines.h"

#include <string>

#include "gpu/raster_pipeline.h"

namespace lampyris::execute {
namespace {

core::Result<void> checkWorkgroup(const gpu::Device& device, const graph::Shader& shader) {
    const VkPhysicalDeviceLimits& limits = device.limits().core;
    const auto& size = shader.workgroupSize;
    for (size_t axis = 0; axis < 3; ++axis)
        if (size[axis] > limits.maxComputeWorkGroupSize[axis])
            return core::error(
                "shader {}: a workgroup of {} along axis {} is more than the device's "
                "maxComputeWorkGroupSize, {}",
                shader.name, size[axis], axis, limits.maxComputeWorkGroupSize[axis]);
    const uint64_t invocations = uint64_t{size[0]} * size[1] * size[2];
    if (invocations > limits.maxComputeWorkGroupInvocations)
        return core::error(
            "shader {}: {} threads a workgroup are more than the device's "
            "maxComputeWorkGroupInvocations, {}",
            shader.name, invocations, limits.maxComputeWorkGroupInvocations);
    return {};
}

std::vector<uint32_t> wordsOf(const std::vector<graph::Specialisation>& specialisations) {
    std::vector<uint32_t> words;
    for (const graph::Specialisation& one : specialisations)
        words.insert(words.end(), {one.id, one.value});
    return words;
}

std::vector<uint32_t> wordsOf(const graph::RasterPipeline& pipeline) {
    std::vector<uint32_t> words{pipeline.depthTest ? 1u : 0u, pipeline.depthWrite ? 1u : 0u,
                                pipeline.depthEqual ? 1u : 0u, pipeline.lines ? 1u : 0u,
                                pipeline.blend ? 1u : 0u};
    for (const graph::VertexAttribute& attribute : pipeline.attributes)
        words.insert(words.end(), {attribute.location, attribute.stream, attribute.components,
                                   attribute.strideBytes});
    return words;
}

VkFormat vertexFormat(uint32_t components) {
    constexpr VkFormat kFormats[] = {VK_FORMAT_R32_SFLOAT, VK_FORMAT_R32G32_SFLOAT,
                                     VK_FORMAT_R32G32B32_SFLOAT, VK_FORMAT_R32G32B32A32_SFLOAT};
    return kFormats[components - 1];
}

}  // namespace

core::Result<Program> Pipelines::compute(
    const graph::Shader& shader, const std::vector<graph::Specialisation>& specialisations) {
    TRY(const SetLayout* setLayout, layout({{&shader, VK_SHADER_STAGE_COMPUTE_BIT}}));
    gpu::Pipeline& place = compute_[{&shader, wordsOf(specialisations)}];
    if (!place) {
        TRY(place, makeCompute(shader, specialisations, *setLayout));
    }
    return Program{place.get(), setLayout};
}

core::Result<Program> Pipelines::raster(const graph::RasterPipeline& pipeline,
                                        const AttachmentFormats& formats) {
    std::vector<StageShader> stages{{pipeline.vertex, VK_SHADER_STAGE_VERTEX_BIT}};
    if (pipeline.fragment != nullptr)
        stages.push_back({pipeline.fragment, VK_SHADER_STAGE_FRAGMENT_BIT});
    TRY(const SetLayout* setLayout, layout(stages));
    gpu::Pipeline& place =
        raster_[{Shaders{pipeline.vertex, pipeline.fragment}, wordsOf(pipeline), formats}];
    if (!place) {
        TRY(place, makeRaster(pipeline, formats, *setLayout));
    }
    return Program{place.get(), setLayout};
}

core::Result<VkShaderModule> Pipelines::module(const graph::Shader& shader) {
    gpu::ShaderModule& place = modules_[&shader];
    if (!place) {
        TRY(place, gpu::createShaderModule(*device_, shader.words, std::string{shader.name}));
    }
    return place.get();
}

core::Result<const SetLayout*> Pipelines::layout(const std::vector<StageShader>& stages) {
    const Shaders key{stages.front().shader, stages.size() > 1 ? stages.back().shader : nullptr};
    std::unique_ptr<SetLayout>& place = layouts_[key];
    if (place == nullptr) {
        TRY(SetLayout made, makeSetLayout(*device_, stages));
        place = std::make_unique<SetLayout>(std::move(made));
    }
    return place.get();
}

core::Result<gpu::Pipeline> Pipelines::makeCompute(
    const graph::Shader& shader, const std::vector<graph::Specialisation>& specialisations,
    const SetLayout& layout) {
    TRY_VOID(checkWorkgroup(*device_, shader));
    TRY(VkShaderModule shaderModule, module(shader));
    std::vector<gpu::SpecialisationValue> values;
    values.reserve(specialisations.size());
    for (const graph::Specialisation& one : specialisations) values.push_back({one.id, one.value});
    return gpu::createComputePipeline(*device_, {.module = shaderModule,
                                                 .layout = layout.pipeline.get(),
                                                 .specialisation = values,
                                                 .name = std::string{shader.name}});
}

core::Result<gpu::Pipeline> Pipelines::makeRaster(const graph::RasterPipeline& pipeline,
                                                  const AttachmentFormats& formats,
                                                  const SetLayout& layout) {
    gpu::RasterPipelineOptions options;
    TRY(options.vertex, module(*pipeline.vertex));
    if (pipeline.fragment != nullptr) {
        TRY(options.fragment, module(*pipeline.fragment));
    }
    std::map<uint32_t, VkVertexInputBindingDescription> byStream;
    std::vector<VkVertexInputAttributeDescription> attributes;
    for (const graph::VertexAttribute& attribute : pipeline.attributes) {
        byStream[attribute.stream] = {attribute.stream, attribute.strideBytes,
                                      VK_VERTEX_INPUT_RATE_VERTEX};
        attributes.push_back(
            {attribute.location, attribute.stream, vertexFormat(attribute.components), 0});
    }
    std::vector<VkVertexInputBindingDescription> streams;
    streams.reserve(byStream.size());
    for (const auto& [stream, description] : byStream) streams.push_back(description);
    options.layout = layout.pipeline.get();
    options.streams = streams;
    options.attributes = attributes;
    options.colours = formats.colours;
    options.depth = formats.depth;
    options.depthTest = pipeline.depthTest;
    options.depthWrite = pipeline.depthWrite;
    options.depthEqual = pipeline.depthEqual;
    options.lines = pipeline.lines;
    options.blend = pipeline.blend;
    options.name = std::string{pipeline.vertex->name};
    return gpu::createRasterPipeline(*device_, options);
}

}  // namespace lampyris::execute
