#include "execute/translate.h"

#include "core/check.h"

namespace lampyris::execute {
namespace {

using graph::Access;
using graph::NodeKind;

VkPipelineStageFlags2 shaderStagesOf(NodeKind kind) {
    // A slot does not say which of the two shaders of a raster node reads it.
    return kind == NodeKind::Raster
               ? VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT
               : VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
}

constexpr VkPipelineStageFlags2 kDepthStages =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;

}  // namespace

VkFormat formatOf(graph::Format format) {
    switch (format) {
        case graph::Format::R32Uint:
            return VK_FORMAT_R32_UINT;
        case graph::Format::R32Float:
            return VK_FORMAT_R32_SFLOAT;
        case graph::Format::RG32Float:
            return VK_FORMAT_R32G32_SFLOAT;
        case graph::Format::RGBA8Unorm:
            return VK_FORMAT_R8G8B8A8_UNORM;
        case graph::Format::RGBA8Srgb:
            return VK_FORMAT_R8G8B8A8_SRGB;
        case graph::Format::BGRA8Unorm:
            return VK_FORMAT_B8G8R8A8_UNORM;
        case graph::Format::RGBA16Float:
            return VK_FORMAT_R16G16B16A16_SFLOAT;
        case graph::Format::RGBA32Float:
            return VK_FORMAT_R32G32B32A32_SFLOAT;
        case graph::Format::RGBA32Uint:
            return VK_FORMAT_R32G32B32A32_UINT;
        case graph::Format::D32Float:
            return VK_FORMAT_D32_SFLOAT;
        case graph::Format::Undefined:
            break;
    }
    return VK_FORMAT_UNDEFINED;
}

VkImageLayout layoutOf(graph::Layout layout) {
    switch (layout) {
        case graph::Layout::Undefined:
            return VK_IMAGE_LAYOUT_UNDEFINED;
        case graph::Layout::General:
            return VK_IMAGE_LAYOUT_GENERAL;
        case graph::Layout::ReadOnly:
            return VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
        case graph::Layout::ColorAttachment:
            return VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
        case graph::Layout::DepthAttachment:
            return VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL;
        case graph::Layout::DepthReadOnly:
            return VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL;
        case graph::Layout::TransferSource:
            return VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
        case graph::Layout::TransferTarget:
            return VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
        case graph::Layout::Present:
            return VK_IMAGE_LAYOUT_PRESENT_SRC_KHR;
    }
    return VK_IMAGE_LAYOUT_UNDEFINED;
}

VkDescriptorType descriptorTypeOf(graph::SlotKind kind) {
    switch (kind) {
        case graph::SlotKind::StorageBuffer:
            return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        case graph::SlotKind::UniformBuffer:
            return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
        case graph::SlotKind::UniformTexelBuffer:
            return VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
        case graph::SlotKind::StorageTexelBuffer:
            return VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER;
        case graph::SlotKind::SampledImage:
            return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
        case graph::SlotKind::StorageImage:
            return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    }
    return VK_DESCRIPTOR_TYPE_MAX_ENUM;
}

VkImageUsageFlags imageUsageOf(graph::AccessSet accesses) {
    VkImageUsageFlags usage = 0;
    const auto add = [&](Access access, VkImageUsageFlags flags) {
        if (accesses.has(access)) usage |= flags;
    };
    add(Access::Sampled, VK_IMAGE_USAGE_SAMPLED_BIT);
    add(Access::StorageRead, VK_IMAGE_USAGE_STORAGE_BIT);
    add(Access::StorageWrite, VK_IMAGE_USAGE_STORAGE_BIT);
    add(Access::StorageUpdate, VK_IMAGE_USAGE_STORAGE_BIT);
    add(Access::ColorWrite, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
    add(Access::DepthWrite, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
    add(Access::DepthRead, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
    add(Access::TransferRead, VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
    add(Access::TransferWrite, VK_IMAGE_USAGE_TRANSFER_DST_BIT);
    return usage;
}

Scope scopeOf(graph::Touch touch) {
    const VkPipelineStageFlags2 shaders = shaderStagesOf(touch.kind);
    constexpr VkAccessFlags2 kStorage =
        VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
    switch (touch.access) {
        case Access::None:
            return {};
        case Access::Uniform:
            return {shaders, VK_ACCESS_2_UNIFORM_READ_BIT};
        case Access::TexelRead:
        case Access::Sampled:
            return {shaders, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT};
        case Access::StorageRead:
            return {shaders, VK_ACCESS_2_SHADER_STORAGE_READ_BIT};
        case Access::StorageWrite:  // shaders may read back what they wrote, and atomics do
        case Access::StorageUpdate:
            return {shaders, kStorage};
        case Access::ColorWrite:  // loading reads
            return {VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                    VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT};
        case Access::DepthWrite:
            return {kDepthStages, VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT |
                                      VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT};
        case Access::DepthRead:
            return {kDepthStages, VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT};
        case Access::VertexRead:
            return {VK_PIPELINE_STAGE_2_VERTEX_ATTRIBUTE_INPUT_BIT,
                    VK_ACCESS_2_VERTEX_ATTRIBUTE_READ_BIT};
        case Access::IndexRead:
            return {VK_PIPELINE_STAGE_2_INDEX_INPUT_BIT, VK_ACCESS_2_INDEX_READ_BIT};
        case Access::IndirectRead:
            return {VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT, VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT};
        case Access::TransferRead:
            return {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT};
        case Access::TransferWrite:
            return {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT};
        case Access::HostRead:
            return {VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT};
        case Access::Present:  // the presentation engine waits on a semaphore
            return {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, 0};
    }
    return {};
}

Scope scopeOf(const graph::TouchSet& touches) {
    Scope all;
    touches.forEach([&](graph::Touch touch) {
        const Scope scope = scopeOf(touch);
        all.stages |= scope.stages;
        all.accesses |= scope.accesses;
    });
    return all;
}

}  // namespace lampyris::execute
