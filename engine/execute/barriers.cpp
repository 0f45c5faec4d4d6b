#include "execute/barriers.h"

#include "execute/translate.h"
#include "gpu/vulkan_struct.h"

namespace lampyris::execute {
namespace {

using gpu::vulkanStruct;

VkImageSubresourceRange wholeOf(const gpu::Image& image) {
    return {image.aspect(), 0, 1, 0, image.options().layers};
}

VkImageMemoryBarrier2 imageBarrier(const gpu::Image& image, Scope source, Scope destination,
                                   VkImageLayout before, VkImageLayout after) {
    auto barrier = vulkanStruct<VkImageMemoryBarrier2>(VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2);
    barrier.srcStageMask = source.stages;
    barrier.srcAccessMask = source.accesses;
    barrier.dstStageMask = destination.stages;
    barrier.dstAccessMask = destination.accesses;
    barrier.oldLayout = before;
    barrier.newLayout = after;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image.get();
    barrier.subresourceRange = wholeOf(image);
    return barrier;
}

VkBufferMemoryBarrier2 bufferBarrier(const gpu::Buffer& buffer, Scope source, Scope destination) {
    auto barrier = vulkanStruct<VkBufferMemoryBarrier2>(VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2);
    barrier.srcStageMask = source.stages;
    barrier.srcAccessMask = source.accesses;
    barrier.dstStageMask = destination.stages;
    barrier.dstAccessMask = destination.accesses;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.buffer = buffer.get();
    barrier.size = VK_WHOLE_SIZE;
    return barrier;
}

void memoryBarrier(VkCommandBuffer commands, Scope source, Scope destination) {
    auto barrier = vulkanStruct<VkMemoryBarrier2>(VK_STRUCTURE_TYPE_MEMORY_BARRIER_2);
    barrier.srcStageMask = source.stages;
    barrier.srcAccessMask = source.accesses;
    barrier.dstStageMask = destination.stages;
    barrier.dstAccessMask = destination.accesses;
    auto dependency = vulkanStruct<VkDependencyInfo>(VK_STRUCTURE_TYPE_DEPENDENCY_INFO);
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

}  // namespace

void recordHandover(VkCommandBuffer commands, const graph::MemoryBarrier& handover) {
    if (handover.handovers.empty()) return;
    memoryBarrier(commands, scopeOf(handover.source), scopeOf(handover.destination));
}

void recordBarriers(VkCommandBuffer commands, const std::vector<graph::Barrier>& barriers,
                    const Resources& resources) {
    std::vector<VkImageMemoryBarrier2> images;
    std::vector<VkBufferMemoryBarrier2> buffers;
    for (const graph::Barrier& barrier : barriers) {
        const Scope destination = scopeOf(barrier.destination);
        // Nothing in this frame came before: chain to the frame's opening barrier, or to a
        // handover. The accesses too: without them synchronization validation loses the chain from
        // a handover.
        const Scope source = barrier.source.empty() ? destination : scopeOf(barrier.source);
        if (barrier.isImage)
            images.push_back(imageBarrier(resources.image(barrier.resource), source, destination,
                                          layoutOf(barrier.before), layoutOf(barrier.after)));
        else
            buffers.push_back(
                bufferBarrier(resources.buffer(barrier.resource), source, destination));
    }
    if (images.empty() && buffers.empty()) return;
    auto dependency = vulkanStruct<VkDependencyInfo>(VK_STRUCTURE_TYPE_DEPENDENCY_INFO);
    dependency.imageMemoryBarrierCount = static_cast<uint32_t>(images.size());
    dependency.pImageMemoryBarriers = images.data();
    dependency.bufferMemoryBarrierCount = static_cast<uint32_t>(buffers.size());
    dependency.pBufferMemoryBarriers = buffers.data();
    vkCmdPipelineBarrier2(commands, &dependency);
}

void recordTransferBarrier(VkCommandBuffer commands) {
    const Scope transfers{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                          VK_ACCESS_2_TRANSFER_READ_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT};
    memoryBarrier(commands, transfers, transfers);
}

void changeLayout(VkCommandBuffer commands, const gpu::Image& image, VkImageLayout before,
                  VkImageLayout after) {
    const Scope all{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                    VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT};
    const VkImageMemoryBarrier2 barrier = imageBarrier(image, all, all, before, after);
    auto dependency = vulkanStruct<VkDependencyInfo>(VK_STRUCTURE_TYPE_DEPENDENCY_INFO);
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

void clearImage(VkCommandBuffer commands, const gpu::Image& image, const VkClearValue& value) {
    const VkImageSubresourceRange whole = wholeOf(image);
    constexpr VkImageLayout kLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    if (image.aspect() == VK_IMAGE_ASPECT_DEPTH_BIT)
        vkCmdClearDepthStencilImage(commands, image.get(), kLayout, &value.depthStencil, 1, &whole);
    else
        vkCmdClearColorImage(commands, image.get(), kLayout, &value.color, 1, &whole);
}

}  // namespace lampyris::execute
