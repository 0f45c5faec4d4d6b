#include "execute/copy_ring.h"

namespace lampyris::execute {
namespace {

constexpr size_t kTurns = 3;  // one being copied, one that may be, one being read

uint64_t bytesOf(const graph::ImageDesc& desc) {
    return uint64_t{graph::bytesPerTexel(desc.format)} * desc.extent.width * desc.extent.height *
           desc.layers;
}

}  // namespace

core::Result<CopyRing> CopyRing::create(gpu::Device& device) {
    CopyRing ring{device};
    for (size_t i = 0; i < kTurns; ++i) {
        Slot& slot = ring.slots_.emplace_back();
        TRY(slot.commands, gpu::Commands::create(device, "copy for the host"));
        TRY(slot.fence, gpu::createFence(device, false, "copy for the host"));
    }
    return ring;
}

CopyRing::~CopyRing() {
    if (slots_.empty()) return;  // moved from
    device_->settle();
}

core::Result<std::optional<RawImage>> CopyRing::turn(const gpu::Image& image,
                                                     const graph::ImageDesc& desc) {
    Slot& slot = slots_[next_];
    if (slot.buffer.bytes() < bytesOf(desc)) {
        TRY(slot.buffer, gpu::Buffer::create(*device_, {bytesOf(desc), gpu::MemoryUse::ReadBack,
                                                        "copy for the host"}));
    }
    TRY(const VkCommandBuffer commands, slot.commands.begin());
    gpu::fullBarrier(commands);
    VkBufferImageCopy region{};
    region.imageSubresource = {image.aspect(), 0, 0, desc.layers};
    region.imageExtent = {desc.extent.width, desc.extent.height, 1};
    vkCmdCopyImageToBuffer(commands, image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                           slot.buffer.get(), 1, &region);
    gpu::fullBarrier(commands);
    TRY_VOID(slot.commands.end());
    TRY_VOID(gpu::submit(*device_, slot.commands, {.fence = slot.fence.get()}));
    slot.desc = desc;
    slot.pending = true;
    next_ = (next_ + 1) % slots_.size();
    if (!slots_[next_].pending) return std::optional<RawImage>{};
    TRY(RawImage oldest, read(slots_[next_]));
    return std::optional{std::move(oldest)};
}

core::Result<std::optional<RawImage>> CopyRing::takeOldest() {
    for (size_t i = 0; i < slots_.size(); ++i) {
        Slot& slot = slots_[(next_ + i) % slots_.size()];
        if (!slot.pending) continue;
        TRY(RawImage oldest, read(slot));
        return std::optional{std::move(oldest)};
    }
    return std::optional<RawImage>{};
}

core::Result<RawImage> CopyRing::read(Slot& slot) {
    TRY_VOID(gpu::waitAndReset(*device_, slot.fence));
    slot.pending = false;
    const auto mapped = slot.buffer.mapped().first(bytesOf(slot.desc));
    return RawImage{slot.desc, {mapped.begin(), mapped.end()}};
}

}  // namespace lampyris::execute
