/// \file What transients take on this device, for graph::compile.
#pragma once

#include <map>
#include <tuple>

#include "gpu/device.h"
#include "gpu/image.h"
#include "graph/compile.h"

namespace lampyris::execute {

/// The physical image that a description stands for.
[[nodiscard]] gpu::ImageOptions imageOptionsOf(const graph::ImageDesc& desc,
                                               VkImageUsageFlags usage, const std::string& name);

/// Asks the device; remembers the answers. A memory kind is the set of memory types, and whether
/// it holds images.
class DeviceMemoryModel final : public graph::MemoryModel {
 public:
    explicit DeviceMemoryModel(const gpu::Device& device) : device_(&device) {}
    [[nodiscard]] graph::MemoryNeed image(const graph::ImageDesc& desc,
                                          graph::AccessSet accesses) const override;
    [[nodiscard]] graph::MemoryNeed buffer(const graph::BufferDesc& desc,
                                           graph::AccessSet accesses) const override;
    [[nodiscard]] uint64_t maxHeapBytes() const override;

    /// The memory types of a kind that this model gave.
    [[nodiscard]] static uint32_t typeBits(uint32_t memoryKind) { return memoryKind >> 1; }
    [[nodiscard]] static bool holdsImages(uint32_t memoryKind) { return (memoryKind & 1u) != 0; }

 private:
    using ImageKey = std::tuple<graph::Format, uint32_t, uint32_t, uint32_t, uint32_t>;
    const gpu::Device* device_;
    mutable std::map<ImageKey, graph::MemoryNeed> images_;
    mutable std::map<uint64_t, graph::MemoryNeed> buffers_;
};

}  // namespace lampyris::execute
