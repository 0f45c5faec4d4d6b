#include "residency/resident_buffer.h"

#include <algorithm>
#include <cstring>

#include "core/check.h"
#include "gpu/commands.h"

namespace lampyris::residency {
namespace {

/// Copies all of `source`, and waits.
core::Result<void> copyAll(Device& device, const gpu::Buffer& source, const gpu::Buffer& target) {
    TRY(gpu::Commands commands, gpu::Commands::create(device, "grow " + source.name()));
    TRY(const VkCommandBuffer recording, commands.begin());
    gpu::fullBarrier(recording);
    const VkBufferCopy region{0, 0, source.bytes()};
    vkCmdCopyBuffer(recording, source.get(), target.get(), 1, &region);
    gpu::fullBarrier(recording);
    TRY_VOID(commands.end());
    return gpu::submitAndWait(device, commands);
}

/// Up to whole texels of any format.
uint64_t rounded(uint64_t bytes) {
    return (bytes + 255) / 256 * 256;
}

}  // namespace

ResidentBuffer::ResidentBuffer(Device& device, std::string name, uint32_t texelBytes)
    : device_(&device),
      name_(std::move(name)),
      mostBytes_(device.limits().maxBufferSize),
      limit_("maxBufferSize") {
    const VkPhysicalDeviceLimits& limits = device.limits().core;
    const uint64_t seen = texelBytes == 0 ? limits.maxStorageBufferRange
                                          : uint64_t{limits.maxTexelBufferElements} * texelBytes;
    if (seen > mostBytes_) return;
    mostBytes_ = seen;
    limit_ = texelBytes == 0 ? "maxStorageBufferRange" : "maxTexelBufferElements";
}

core::Result<void> ResidentBuffer::reserve(uint64_t bytes) {
    if (buffer_.get() != VK_NULL_HANDLE && bytes <= buffer_.bytes()) return {};
    if (bytes > mostBytes_)
        return core::error("{}: {} bytes are more than the {} that the device's {} allows", name_,
                           bytes, mostBytes_, limit_);
    const bool grows = buffer_.get() != VK_NULL_HANDLE;
    // The first size is exact: most scenes are loaded once. After that, half as much again.
    const uint64_t roomy = grows ? buffer_.bytes() + buffer_.bytes() / 2 : 0;
    const uint64_t size = std::min(rounded(std::max(bytes, roomy)), mostBytes_);
    TRY(gpu::Buffer larger,
        gpu::Buffer::create(*device_,
                            {.bytes = size, .memory = gpu::MemoryUse::Device, .name = name_}));
    if (grows) TRY_VOID(copyAll(*device_, buffer_, larger));
    TRY_VOID(device_->waitIdle());
    buffer_ = std::move(larger);
    return {};
}

core::Result<void> ResidentBuffer::roomInTurn(uint64_t bytes) {
    gpu::Buffer& host = turns_[turn_];
    if (host.get() != VK_NULL_HANDLE && bytes <= host.bytes()) return {};
    const uint64_t size = std::max<uint64_t>(bytes, 2 * (staged_ + 128));
    TRY(gpu::Buffer larger, gpu::Buffer::create(*device_, {.bytes = size,
                                                           .memory = gpu::MemoryUse::Upload,
                                                           .name = name_ + " upload"}));
    if (staged_ > 0) std::memcpy(larger.mapped().data(), host.mapped().data(), staged_);
    host = std::move(larger);
    return {};
}

core::Result<std::span<std::byte>> ResidentBuffer::stageRoom(uint64_t offset, uint64_t bytes) {
    CHECK((offset + bytes) <= buffer_.bytes());
    TRY_VOID(roomInTurn(staged_ + bytes));
    const auto room = turns_[turn_].mapped().subspan(staged_, bytes);
    pieces_.push_back({staged_, offset, bytes});
    staged_ += bytes;
    return room;
}

core::Result<void> ResidentBuffer::stage(uint64_t offset, std::span<const std::byte> bytes) {
    if (bytes.empty()) return {};
    TRY(const std::span<std::byte> room, stageRoom(offset, bytes.size()));
    std::memcpy(room.data(), bytes.data(), bytes.size());
    return {};
}

core::Result<void> ResidentBuffer::sendStaged(gpu::Staging& staging) {
    if (pieces_.empty()) return {};
    const auto host = turns_[turn_].mapped();
    for (const Piece& piece : pieces_) {
        TRY_VOID(staging.write(buffer_, piece.target, host.subspan(piece.source, piece.bytes)));
        TRY_VOID(staging.flush());  // a later piece may lie over it
    }
    pieces_.clear();
    staged_ = 0;
    return {};
}

graph::Buffer ResidentBuffer::import(graph::Frame& frame, const std::string& node) {
    CHECK(buffer_.get() != VK_NULL_HANDLE);
    graph::Buffer target =
        frame.importBuffer(name_, {buffer_.bytes()}, {&buffer_}, graph::Access::TransferWrite);
    if (pieces_.empty()) return target;
    gpu::Buffer& host = turns_[turn_];
    const graph::Buffer source =
        frame.importBuffer(name_ + " upload", {host.bytes()}, {&host}, graph::Access::TransferRead);
    graph::TransferNode upload = frame.transfer(node);
    for (const Piece& piece : pieces_)
        target = upload.copy(source, piece.source, target, piece.target, piece.bytes);
    pieces_.clear();
    staged_ = 0;
    turn_ = (turn_ + 1) % kTurns;
    return target;
}

core::Result<Loading> Loading::begin(Device& device) {
    TRY_VOID(device.waitIdle());
    TRY(gpu::Staging staging, gpu::Staging::create(device));
    return Loading(std::move(staging));
}

core::Result<void> Loading::write(ResidentBuffer& target, uint64_t offset,
                                  std::span<const std::byte> bytes) {
    if (bytes.empty()) return {};
    CHECK((offset + bytes.size()) <= target.bytes());
    TRY_VOID(target.sendStaged(staging_));
    return staging_.write(target.buffer_, offset, bytes);
}

}  // namespace lampyris::residency
