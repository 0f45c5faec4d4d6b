#include "gpu/staging.h"

#include <algorithm>
#include <cstring>

#include "core/check.h"
#include "gpu/vulkan_struct.h"

namespace lampyris::gpu {
namespace {

// [chosen] Large enough that a copy costs more than its submit, small beside a scene.
constexpr uint64_t kStagingBytes = uint64_t{32} << 20;
constexpr uint64_t kAlignment = 16;  // of every texel format and of vkCmdCopyBufferToImage

void imageBarrier(VkCommandBuffer commands, const Image& image, uint32_t layer,
                  VkImageLayout before, VkImageLayout after) {
    auto barrier = vulkanStruct<VkImageMemoryBarrier2>(VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2);
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.oldLayout = before;
    barrier.newLayout = after;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image.get();
    barrier.subresourceRange = {image.aspect(), 0, 1, layer, 1};
    auto dependency = vulkanStruct<VkDependencyInfo>(VK_STRUCTURE_TYPE_DEPENDENCY_INFO);
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

}  // namespace

core::Result<Staging> Staging::create(Device& device) {
    Staging staging{device};
    TRY(staging.buffer_, Buffer::create(device, {kStagingBytes, MemoryUse::Upload, "staging"}));
    TRY(staging.commands_, Commands::create(device, "staging"));
    return staging;
}

core::Result<uint64_t> Staging::take(std::span<const std::byte> bytes, uint64_t unit) {
    used_ = (used_ + kAlignment - 1) / kAlignment * kAlignment;
    if (used_ + std::min<uint64_t>(unit, bytes.size()) > kStagingBytes) TRY_VOID(flush());
    CHECK(unit <= kStagingBytes);
    const uint64_t room = (kStagingBytes - used_) / unit * unit;
    const uint64_t count = std::min<uint64_t>(bytes.size(), room);
    std::memcpy(buffer_.mapped().data() + used_, bytes.data(), count);
    return count;
}

core::Result<void> Staging::write(const Buffer& target, uint64_t offset,
                                  std::span<const std::byte> bytes) {
    CHECK((offset + bytes.size()) <= target.bytes());
    while (!bytes.empty()) {
        TRY(const uint64_t count, take(bytes, 4));
        pieces_.push_back({&target, nullptr, offset, 0, 0, used_, count});
        used_ += count;
        offset += count;
        bytes = bytes.subspan(count);
    }
    return {};
}

core::Result<void> Staging::write(const Image& target, uint32_t layer,
                                  std::span<const std::byte> bytes) {
    const uint32_t rows = target.options().extent.height;
    const uint64_t rowBytes = bytes.size() / rows;
    CHECK((rowBytes * rows) == bytes.size());
    for (uint32_t row = 0; row < rows;) {
        TRY(const uint64_t count, take(bytes, rowBytes));
        const auto taken = static_cast<uint32_t>(count / rowBytes);
        pieces_.push_back({nullptr, &target, layer, row, taken, used_, count});
        used_ += count;
        row += taken;
        bytes = bytes.subspan(count);
    }
    return {};
}

void Staging::record(VkCommandBuffer commands, const Piece& piece) const {
    if (piece.buffer != nullptr) {
        const VkBufferCopy region{piece.stagingOffset, piece.offset, piece.bytes};
        vkCmdCopyBuffer(commands, buffer_.get(), piece.buffer->get(), 1, &region);
        return;
    }
    const Image& image = *piece.image;
    const auto layer = static_cast<uint32_t>(piece.offset);
    // The rows before this piece may lie in an earlier one.
    imageBarrier(
        commands, image, layer,
        piece.row == 0 ? VK_IMAGE_LAYOUT_UNDEFINED : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
        VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    VkBufferImageCopy region{};
    region.bufferOffset = piece.stagingOffset;
    region.imageSubresource = {image.aspect(), 0, layer, 1};
    region.imageOffset.y = static_cast<int32_t>(piece.row);
    region.imageExtent = {image.options().extent.width, piece.rows, 1};
    vkCmdCopyBufferToImage(commands, buffer_.get(), image.get(),
                           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    imageBarrier(commands, image, layer, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                 VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
}

core::Result<void> Staging::flush() {
    if (pieces_.empty()) return {};
    TRY(const VkCommandBuffer commands, commands_.begin());
    fullBarrier(commands);
    for (const Piece& piece : pieces_) record(commands, piece);
    fullBarrier(commands);
    TRY_VOID(commands_.end());
    pieces_.clear();
    used_ = 0;
    return submitAndWait(*device_, commands_);
}

core::Result<std::vector<std::byte>> Staging::read(const Buffer& source, uint64_t offset,
                                                   uint64_t bytes) {
    CHECK((offset + bytes) <= source.bytes());
    TRY_VOID(flush());
    std::vector<std::byte> result;
    result.reserve(bytes);
    TRY(const Buffer target, Buffer::create(*device_, {std::min(bytes, kStagingBytes),
                                                       MemoryUse::ReadBack, "read back"}));
    while (result.size() < bytes) {
        const uint64_t count = std::min(bytes - result.size(), kStagingBytes);
        TRY(const VkCommandBuffer commands, commands_.begin());
        fullBarrier(commands);
        const VkBufferCopy region{offset + result.size(), 0, count};
        vkCmdCopyBuffer(commands, source.get(), target.get(), 1, &region);
        fullBarrier(commands);
        TRY_VOID(commands_.end());
        TRY_VOID(submitAndWait(*device_, commands_));
        const std::span got = target.mapped().first(count);
        result.insert(result.end(), got.begin(), got.end());
    }
    return result;
}

}  // namespace lampyris::gpu
