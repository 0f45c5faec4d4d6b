#include "execute/uniform_ring.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace lampyris::execute {
namespace {

// [chosen] A frame has some tens of nodes of some hundred bytes each.
constexpr uint64_t kBlockBytes = uint64_t{256} << 10;

}  // namespace

core::Result<UniformRing::Place> UniformRing::add(std::span<const uint8_t> bytes, bool storage) {
    const VkPhysicalDeviceLimits& limits = device_->limits().core;
    const uint32_t most = storage ? limits.maxStorageBufferRange : limits.maxUniformBufferRange;
    if (bytes.size() > most)
        return core::error("{} bytes are more than the device's {}, {}", bytes.size(),
                           storage ? "maxStorageBufferRange" : "maxUniformBufferRange", most);
    const uint64_t alignment =
        std::max<uint64_t>({limits.minUniformBufferOffsetAlignment,
                            limits.minStorageBufferOffsetAlignment, sizeof(float) * 4});
    uint64_t offset = (used_ + alignment - 1) / alignment * alignment;
    while (block_ < blocks_.size() && offset + bytes.size() > blocks_[block_].bytes()) {
        ++block_;
        offset = 0;
    }
    if (block_ == blocks_.size()) {
        TRY(gpu::Buffer fresh,
            gpu::Buffer::create(
                *device_, {.bytes = std::bit_ceil(std::max<uint64_t>(kBlockBytes, bytes.size())),
                           .memory = gpu::MemoryUse::Upload,
                           .name = "uniforms"}));
        blocks_.push_back(std::move(fresh));
    }
    std::memcpy(blocks_[block_].mapped().data() + offset, bytes.data(), bytes.size());
    used_ = offset + bytes.size();
    return Place{blocks_[block_].get(), offset, bytes.size()};
}

void UniformRing::reset() {
    block_ = 0;
    used_ = 0;
}

}  // namespace lampyris::execute
