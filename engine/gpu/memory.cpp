#include "gpu/memory.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/check.h"
#include "gpu/vulkan_result.h"
#include "gpu/vulkan_struct.h"

namespace lampyris::gpu {

/// Free ranges lie sorted and never touch.
struct MemoryBlock {
    struct Range {
        uint64_t offset;
        uint64_t bytes;
    };
    VkDeviceMemory memory = VK_NULL_HANDLE;
    uint64_t bytes = 0;
    uint32_t type = 0;
    bool linear = true;
    std::byte* mapped = nullptr;
    std::vector<Range> free;

    std::optional<uint64_t> take(uint64_t wanted, uint64_t alignment) {
        for (auto range = free.begin(); range != free.end(); ++range) {
            const uint64_t start = (range->offset + alignment - 1) / alignment * alignment;
            const uint64_t end = range->offset + range->bytes;
            if (start + wanted > end) continue;
            const Range before{range->offset, start - range->offset};
            const Range after{start + wanted, end - start - wanted};
            range = free.erase(range);
            if (after.bytes > 0) range = free.insert(range, after);
            if (before.bytes > 0) free.insert(range, before);
            return start;
        }
        return std::nullopt;
    }

    void give(uint64_t offset, uint64_t count) {
        auto next = std::find_if(free.begin(), free.end(),
                                 [&](const Range& range) { return range.offset > offset; });
        auto range = free.insert(next, {offset, count});
        next = range + 1;
        if (next != free.end() && range->offset + range->bytes == next->offset) {
            range->bytes += next->bytes;
            free.erase(next);
        }
        if (range == free.begin()) return;
        const auto previous = range - 1;
        if (previous->offset + previous->bytes != range->offset) return;
        previous->bytes += range->bytes;
        free.erase(range);
    }

    [[nodiscard]] bool empty() const { return free.size() == 1 && free.front().bytes == bytes; }
};

namespace {

// [chosen] Few enough allocations for drivers that allow 4096; small beside a scene.
constexpr uint64_t kBlockBytes = uint64_t{64} << 20;
constexpr uint64_t kOwnBlockBytes = kBlockBytes / 4;

constexpr VkMemoryPropertyFlags kHost =
    VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;

/// In order of preference; the last one is what must be there.
std::array<VkMemoryPropertyFlags, 2> wishes(MemoryUse use) {
    switch (use) {
        case MemoryUse::Upload:
            return {kHost, kHost};
        case MemoryUse::ReadBack:
            return {kHost | VK_MEMORY_PROPERTY_HOST_CACHED_BIT, kHost};
        default:
            return {VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0};
    }
}

}  // namespace

Allocation& Allocation::operator=(Allocation&& other) noexcept {
    std::swap(allocator_, other.allocator_);
    std::swap(block_, other.block_);
    std::swap(offset_, other.offset_);
    std::swap(bytes_, other.bytes_);
    return *this;
}

Allocation::~Allocation() {
    if (block_ != nullptr) allocator_->release(block_, offset_, bytes_);
}

VkDeviceMemory Allocation::memory() const {
    return block_->memory;
}

std::byte* Allocation::mapped() const {
    return block_->mapped == nullptr ? nullptr : block_->mapped + offset_;
}

MemoryAllocator::MemoryAllocator(VkPhysicalDevice physical, VkDevice device,
                                 uint64_t maxAllocationBytes)
    : device_(device), maxAllocationBytes_(maxAllocationBytes) {
    vkGetPhysicalDeviceMemoryProperties(physical, &properties_);
}

MemoryAllocator::~MemoryAllocator() {
    for (const auto& block : blocks_) {
        CHECK(block->empty());
        vkFreeMemory(device_, block->memory, nullptr);
    }
}

core::Result<Allocation> MemoryAllocator::allocate(const VkMemoryRequirements& needs, MemoryUse use,
                                                   bool linear, const char* what) {
    TRY(const uint32_t type, chooseType(needs.memoryTypeBits, use, what));
    const std::scoped_lock lock{mutex_};
    Allocation allocation;
    allocation.allocator_ = this;
    allocation.bytes_ = needs.size;
    const bool own = needs.size > kOwnBlockBytes;
    for (const auto& block : blocks_) {
        if (own || block->type != type || block->linear != linear) continue;
        const auto offset = block->take(needs.size, needs.alignment);
        if (!offset) continue;
        allocation.offset_ = *offset;
        allocation.block_ = block.get();
        return allocation;
    }
    TRY(MemoryBlock * block, addBlock(own ? needs.size : kBlockBytes, type, linear, what));
    allocation.offset_ = *block->take(needs.size, needs.alignment);
    allocation.block_ = block;
    return allocation;
}

core::Result<MemoryBlock*> MemoryAllocator::addBlock(uint64_t bytes, uint32_t type, bool linear,
                                                     const char* what) {
    if (bytes > maxAllocationBytes_)
        return core::error("{}: {} bytes are more than the device's maxMemoryAllocationSize, {}",
                           what, bytes, maxAllocationBytes_);
    auto block = std::make_unique<MemoryBlock>();
    block->bytes = bytes;
    block->type = type;
    block->linear = linear;
    block->free.push_back({0, bytes});
    auto info = vulkanStruct<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
    info.allocationSize = bytes;
    info.memoryTypeIndex = type;
    const VkResult result = vkAllocateMemory(device_, &info, nullptr, &block->memory);
    if (result != VK_SUCCESS)
        return core::error("{}: no device memory for {} bytes ({})", what, bytes,
                           resultName(result));
    if ((properties_.memoryTypes[type].propertyFlags & kHost) == kHost) {
        void* mapped = nullptr;
        const VkResult map = vkMapMemory(device_, block->memory, 0, VK_WHOLE_SIZE, 0, &mapped);
        if (map != VK_SUCCESS) {
            vkFreeMemory(device_, block->memory, nullptr);
            return vulkanError(map, "vkMapMemory");
        }
        block->mapped = static_cast<std::byte*>(mapped);
    }
    blocks_.push_back(std::move(block));
    return blocks_.back().get();
}

core::Result<uint32_t> MemoryAllocator::chooseType(uint32_t typeBits, MemoryUse use,
                                                   const char* what) const {
    for (const VkMemoryPropertyFlags wish : wishes(use))
        for (uint32_t type = 0; type < properties_.memoryTypeCount; ++type)
            if ((typeBits >> type & 1u) != 0 &&
                (properties_.memoryTypes[type].propertyFlags & wish) == wish)
                return type;
    return core::error("{}: the device has no memory type for it", what);
}

uint64_t MemoryAllocator::bytes() const {
    const std::scoped_lock lock{mutex_};
    uint64_t sum = 0;
    for (const auto& block : blocks_) sum += block->bytes;
    return sum;
}

void MemoryAllocator::release(MemoryBlock* block, uint64_t offset, uint64_t bytes) {
    const std::scoped_lock lock{mutex_};
    block->give(offset, bytes);
    if (!block->empty()) return;
    vkFreeMemory(device_, block->memory, nullptr);
    std::erase_if(blocks_, [&](const auto& candidate) { return candidate.get() == block; });
}

}  // namespace lampyris::gpu
