/// \file Every pipeline that was asked for, made once: by shader, specialisation and fixed state.
#pragma once

#include <vulkan/vulkan.h>

#include <map>
#include <memory>
#include <span>
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

    /// Those asked for so far.
    [[nodiscard]] std::vector<const graph::Shader*> shaders() const;
    /// Puts other words in a shader's place, in all pipelines that were made of it: in all, or,
    /// where one of them cannot be made, in none. Their slots are taken for the same. The device
    /// must be idle.
    core::Result<void> replace(const graph::Shader& shader, std::span<const uint32_t> words);

 private:
    using Shaders = std::pair<const graph::Shader*, const graph::Shader*>;
    using Words = std::vector<uint32_t>;
    struct Raster {
        graph::RasterPipeline options;
        gpu::Pipeline pipeline;
    };
    /// A pipeline's place, and what shall stand there.
    using Remade = std::vector<std::pair<gpu::Pipeline*, gpu::Pipeline>>;
    core::Result<VkShaderModule> module(const graph::Shader& shader);
    core::Result<const SetLayout*> layout(const std::vector<StageShader>& stages);
    core::Result<gpu::Pipeline> makeCompute(
        const graph::Shader& shader, const std::vector<graph::Specialisation>& specialisations,
        const SetLayout& layout);
    core::Result<gpu::Pipeline> makeRaster(const graph::RasterPipeline& pipeline,
                                           const AttachmentFormats& formats,
                                           const SetLayout& layout);
    core::Result<Remade> remake(const graph::Shader& shader);

    gpu::Device* device_;
    std::map<const graph::Shader*, gpu::ShaderModule> modules_;
    std::map<Shaders, std::unique_ptr<SetLayout>> layouts_;
    std::map<std::pair<const graph::Shader*, Words>, gpu::Pipeline> compute_;
    std::map<std::tuple<Shaders, Words, AttachmentFormats>, Raster> raster_;
};

}  // namespace lampyris::execute
