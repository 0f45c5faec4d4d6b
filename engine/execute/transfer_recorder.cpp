#include <algorithm>
#include <bit>

#include "execute/barriers.h"
#include "execute/recording.h"

namespace lampyris::execute {
namespace {

using graph::Copy;

constexpr VkImageLayout kSource = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
constexpr VkImageLayout kTarget = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;

VkImageSubresourceLayers layersOf(const gpu::Image& image) {
    return {image.aspect(), 0, 0, image.options().layers};
}

VkExtent3D extentOf(const gpu::Image& image) {
    return {image.options().extent.width, image.options().extent.height, 1};
}

VkOffset3D cornerOf(const gpu::Image& image) {
    return {static_cast<int32_t>(image.options().extent.width),
            static_cast<int32_t>(image.options().extent.height), 1};
}

/// Linear where the format can, unless nothing is scaled.
VkFilter filterFor(const gpu::Device& device, const gpu::Image& source, const gpu::Image& target) {
    const VkExtent2D a = source.options().extent;
    const VkExtent2D b = target.options().extent;
    if (a.width == b.width && a.height == b.height) return VK_FILTER_NEAREST;
    VkFormatProperties properties{};
    vkGetPhysicalDeviceFormatProperties(device.physical(), source.options().format, &properties);
    const bool linear =
        (properties.optimalTilingFeatures & VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT) != 0;
    return linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
}

void copyImage(VkCommandBuffer commands, const gpu::Image& source, const gpu::Image& target) {
    VkImageCopy region{};
    region.srcSubresource = layersOf(source);
    region.dstSubresource = layersOf(target);
    region.extent = extentOf(source);
    vkCmdCopyImage(commands, source.get(), kSource, target.get(), kTarget, 1, &region);
}

void copyToBuffer(VkCommandBuffer commands, const gpu::Image& source, const gpu::Buffer& target,
                  uint64_t offset) {
    VkBufferImageCopy region{};
    region.bufferOffset = offset;
    region.imageSubresource = layersOf(source);
    region.imageExtent = extentOf(source);
    vkCmdCopyImageToBuffer(commands, source.get(), kSource, target.get(), 1, &region);
}

void copyToImage(VkCommandBuffer commands, const gpu::Buffer& source, const gpu::Image& target,
                 const Copy& copy) {
    VkBufferImageCopy region{};
    region.bufferOffset = copy.sourceOffset;
    region.imageSubresource = {target.aspect(), 0, copy.targetLayer, 1};
    region.imageExtent = extentOf(target);
    vkCmdCopyBufferToImage(commands, source.get(), target.get(), kTarget, 1, &region);
}

void blit(const Recording& recording, const gpu::Image& source, const gpu::Image& target) {
    VkImageBlit region{};
    region.srcSubresource = layersOf(source);
    region.srcOffsets[1] = cornerOf(source);
    region.dstSubresource = layersOf(target);
    region.dstOffsets[1] = cornerOf(target);
    vkCmdBlitImage(recording.commands, source.get(), kSource, target.get(), kTarget, 1, &region,
                   filterFor(recording.device, source, target));
}

void recordCopy(const Recording& recording, const Copy& copy) {
    const Resources& resources = recording.resources;
    const VkCommandBuffer commands = recording.commands;
    switch (copy.kind) {
        case Copy::Kind::BufferToBuffer: {
            const VkBufferCopy region{copy.sourceOffset, copy.targetOffset, copy.bytes};
            vkCmdCopyBuffer(commands, resources.buffer(copy.sourceResource).get(),
                            resources.buffer(copy.targetResource).get(), 1, &region);
            return;
        }
        case Copy::Kind::ImageToImage:
            copyImage(commands, resources.image(copy.sourceResource),
                      resources.image(copy.targetResource));
            return;
        case Copy::Kind::ImageToBuffer:
            copyToBuffer(commands, resources.image(copy.sourceResource),
                         resources.buffer(copy.targetResource), copy.targetOffset);
            return;
        case Copy::Kind::BufferToImage:
            copyToImage(commands, resources.buffer(copy.sourceResource),
                        resources.image(copy.targetResource), copy);
            return;
        case Copy::Kind::Fill:
            vkCmdFillBuffer(commands, resources.buffer(copy.targetResource).get(),
                            copy.targetOffset, copy.bytes, copy.fillValue);
            return;
        case Copy::Kind::Blit:
            blit(recording, resources.image(copy.sourceResource),
                 resources.image(copy.targetResource));
            return;
    }
}

VkClearValue poisonOf(graph::Format format) {
    VkClearValue value{};
    const auto nan = std::bit_cast<float>(graph::kPoisonWord);
    switch (format) {
        case graph::Format::D32Float:  // Vulkan clears depth to 0 … 1 only
            value.depthStencil.depth = 0.5f;
            break;
        case graph::Format::R32Uint:
        case graph::Format::RGBA32Uint:
            std::fill_n(value.color.uint32, 4, graph::kPoisonWord);
            break;
        case graph::Format::RGBA8Unorm:
        case graph::Format::RGBA8Srgb:
        case graph::Format::BGRA8Unorm:  // magenta: they have no NaN
            value.color = {{1.0f, 0.0f, 1.0f, 1.0f}};
            break;
        default:
            std::fill_n(value.color.float32, 4, nan);
    }
    return value;
}

}  // namespace

void recordTransfer(Recording& recording, const graph::Node& node, const graph::Step& step) {
    for (uint32_t i = 0; i < node.copies.size(); ++i) {
        if (std::count(step.copyBarriers.begin(), step.copyBarriers.end(), i) > 0)
            recordTransferBarrier(recording.commands);
        recordCopy(recording, node.copies[i]);
    }
}

void recordPoison(Recording& recording, const graph::Step& step) {
    for (const uint32_t resource : step.poisons) {
        const graph::ResourceInfo& info = recording.frame.resources()[resource];
        if (info.isImage)
            clearImage(recording.commands, recording.resources.image(resource),
                       poisonOf(info.image.format));
        else
            vkCmdFillBuffer(recording.commands, recording.resources.buffer(resource).get(), 0,
                            VK_WHOLE_SIZE, graph::kPoisonWord);
    }
}

}  // namespace lampyris::execute
