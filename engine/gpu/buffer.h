/// \file Device buffers, and typed views of them for texel fetches.
#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "core/result.h"
#include "gpu/device.h"
#include "gpu/handle.h"

namespace lampyris::gpu {

struct BufferOptions {
    uint64_t bytes = 0;  ///< 0 is made 16, as Vulkan has no empty buffers
    MemoryUse memory = MemoryUse::Device;
    std::string name{};
};

/// A buffer that may be used for everything: storage, uniform, texels, vertices, indices, indirect
/// arguments and copies.
class Buffer {
 public:
    Buffer();
    Buffer(Buffer&&) noexcept;
    Buffer& operator=(Buffer&&) noexcept;
    ~Buffer();

    /// An Error names the buffer and, where one is in the way, the limit.
    static core::Result<Buffer> create(Device& device, const BufferOptions& options);
    /// A buffer without memory; bind() gives it some.
    static core::Result<Buffer> createUnbound(Device& device, const BufferOptions& options);
    /// Places it at `offset` bytes of memory that outlives it.
    core::Result<void> bind(const Allocation& memory, uint64_t offset);

    [[nodiscard]] VkBuffer get() const { return buffer_.get(); }
    [[nodiscard]] uint64_t bytes() const { return bytes_; }
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] VkMemoryRequirements memoryRequirements() const;
    /// Its bytes on the host; empty for MemoryUse::Device.
    [[nodiscard]] std::span<std::byte> mapped() const;
    /// The same bytes as texels of `format`, `texelBytes` each; 0 bytes is up to the end. Kept for
    /// the next call. An Error names maxTexelBufferElements where the view has more texels.
    core::Result<VkBufferView> view(VkFormat format, uint32_t texelBytes, uint64_t offset = 0,
                                    uint64_t bytes = 0) const;

 private:
    struct Views;
    Device* device_ = nullptr;
    Allocation memory_;
    Handle<VkBuffer, vkDestroyBuffer> buffer_;
    std::unique_ptr<Views> views_;
    uint64_t bytes_ = 0;
    std::string name_;
};

/// What a buffer of this size takes, without making one.
[[nodiscard]] VkMemoryRequirements bufferMemoryRequirements(const Device& device, uint64_t bytes);

}  // namespace lampyris::gpu
