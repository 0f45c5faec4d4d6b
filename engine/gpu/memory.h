/// \file Device memory in blocks, handed out in pieces. Host-visible memory is coherent and stays
/// mapped.
#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "core/result.h"

namespace lampyris::gpu {

/// What memory is for.
enum class MemoryUse : uint8_t {
    Device,    ///< the device reads and writes it; not mapped
    Upload,    ///< the host writes, the device reads
    ReadBack,  ///< the device writes, the host reads
};

class MemoryAllocator;
struct MemoryBlock;

/// A piece of a block. Goes back when destroyed; the allocator must outlive it.
class Allocation {
 public:
    Allocation() = default;
    Allocation(Allocation&& other) noexcept { *this = std::move(other); }
    Allocation& operator=(Allocation&& other) noexcept;
    Allocation(const Allocation&) = delete;
    Allocation& operator=(const Allocation&) = delete;
    ~Allocation();

    [[nodiscard]] bool valid() const { return block_ != nullptr; }
    [[nodiscard]] VkDeviceMemory memory() const;
    [[nodiscard]] uint64_t offset() const { return offset_; }
    [[nodiscard]] uint64_t bytes() const { return bytes_; }
    [[nodiscard]] std::byte* mapped() const;  ///< null where not host-visible

 private:
    friend class MemoryAllocator;
    MemoryAllocator* allocator_ = nullptr;
    MemoryBlock* block_ = nullptr;
    uint64_t offset_ = 0;
    uint64_t bytes_ = 0;
};

/// First fit in blocks of 64 MiB; what is larger than a quarter of one gets a block of its own.
class MemoryAllocator {
 public:
    /// `maxAllocationBytes` is the limit maxMemoryAllocationSize.
    MemoryAllocator(VkPhysicalDevice physical, VkDevice device, uint64_t maxAllocationBytes);
    ~MemoryAllocator();
    MemoryAllocator(const MemoryAllocator&) = delete;
    MemoryAllocator& operator=(const MemoryAllocator&) = delete;

    /// `linear`: for buffers; images with optimal tiling never share a block with them
    /// (bufferImageGranularity). Errors name `what` and the limit or the VkResult.
    core::Result<Allocation> allocate(const VkMemoryRequirements& needs, MemoryUse use, bool linear,
                                      const char* what);
    /// Bytes of all blocks.
    [[nodiscard]] uint64_t bytes() const;

 private:
    friend class Allocation;
    core::Result<MemoryBlock*> addBlock(uint64_t bytes, uint32_t type, bool linear,
                                        const char* what);
    core::Result<uint32_t> chooseType(uint32_t typeBits, MemoryUse use, const char* what) const;
    void release(MemoryBlock* block, uint64_t offset, uint64_t bytes);

    VkDevice device_;
    uint64_t maxAllocationBytes_;
    VkPhysicalDeviceMemoryProperties properties_{};
    mutable std::mutex mutex_;
    std::vector<std::unique_ptr<MemoryBlock>> blocks_;
};

}  // namespace lampyris::gpu
