/// \file Every pipeline that was asked for, made once: by shader, specialisation and fixed state.
#pragma once

#include <vulkan/vulkan.h>

#include <map>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "core/result.h"
#include "execute/set_layouts.h"
#include "gpu/compute_pipeline.h"
#include "gpu/shader_module.h"
#include "graph/node.h"

namespace lampyris::execute {

struct Program {
    VkPipeline pipeline = VK_NULL_HANDLE;
    const SetLayout* layout = nullptr;
};

/// What a raster node draws into.
struct AttachmentFormats {
    std::vector<VkFormat> colours;  ///< by location
    VkFormat depth = VK_FORMAT_UNDEFINED;
    bool operator<(const AttachmentFormats& other) const {
        return std::tie(colours, depth) < std::tie(other.colours, other.depth);
    }
};

class Pipelines {
 public:
    explicit Pipelines(gpu::Device& device) : device_(&device) {}
    /// Errors name the shader and, where one is in the way, the limit.
    core::Result<Program> compute(const graph::Shader& shader,
                                  const std::vector<graph::Specialisation>& specialisations);
    core::Result<Program> raster(const graph::RasterPipeline& pipeline,
                                 const AttachmentFormats& formats);

 private:
    using Shaders = std::pair<const graph::Shader*, const graph::Shader*>;
    using Words = std::vector<uint32_t>;
    core::Result<VkShaderModule> module(const graph::Shader& shader);
    core::Result<const SetLayout*> layout(const std::vector<StageShader>& stages);
    core::Result<gpu::Pipeline> makeCompute(
        const graph::Shader& shader, const std::vector<graph::Specialisation>& specialisations,
        const SetLayout& layout);
    core::Result<gpu::Pipeline> makeRaster(const graph::RasterPipeline& pipeline,
                                           const AttachmentFormats& formats,
                                           const SetLayout& layout);

    gpu::Device* device_;
    std::map<const graph::Shader*, gpu::ShaderModule> modules_;
    std::map<Shaders, std::unique_ptr<SetLayout>> layouts_;
    std::map<std::pair<const graph::Shader*, Words>, gpu::Pipeline> compute_;
    std::map<std::tuple<Shaders, Words, AttachmentFormats>, gpu::Pipeline> raster_;
};

}  // namespace lampyris::execute
