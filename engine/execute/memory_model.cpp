#include "execute/memory_model.h"

#include <algorithm>

#include "execute/translate.h"
#include "gpu/buffer.h"

namespace lampyris::execute {
namespace {

// [chosen] Several small heaps fit fragmented device memory better than one of everything.
constexpr uint64_t kMaxHeapBytes = uint64_t{1} << 30;

graph::MemoryNeed needOf(const VkMemoryRequirements& requirements, bool isImage) {
    // Memory types are at most 32, but none has ever had more than 31: the lowest bit is free for
    // images, which must not share pages with buffers (bufferImageGranularity).
    return {.bytes = requirements.size,
            .alignment = requirements.alignment,
            .memoryKind = requirements.memoryTypeBits << 1 | (isImage ? 1u : 0u)};
}

}  // namespace

gpu::ImageOptions imageOptionsOf(const graph::ImageDesc& desc, VkImageUsageFlags usage,
                                 const std::string& name) {
    return {.format = formatOf(desc.format),
            .extent = {desc.extent.width, desc.extent.height},
            .layers = desc.layers,
            .array = desc.array,
            .usage = usage,
            .name = name};
}

graph::MemoryNeed DeviceMemoryModel::image(const graph::ImageDesc& desc,
                                           graph::AccessSet accesses) const {
    const ImageKey key{desc.format, desc.extent.width, desc.extent.height, desc.layers,
                       accesses.bits};
    const auto [place, isNew] = images_.try_emplace(key);
    if (isNew) {
        const auto options = imageOptionsOf(desc, imageUsageOf(accesses), "");
        place->second = needOf(gpu::imageMemoryRequirements(*device_, options), true);
    }
    return place->second;
}

graph::MemoryNeed DeviceMemoryModel::buffer(const graph::BufferDesc& desc, graph::AccessSet) const {
    const auto [place, isNew] = buffers_.try_emplace(desc.bytes);
    if (isNew) place->second = needOf(gpu::bufferMemoryRequirements(*device_, desc.bytes), false);
    return place->second;
}

uint64_t DeviceMemoryModel::maxHeapBytes() const {
    return std::min(kMaxHeapBytes, device_->limits().maxMemoryAllocationSize);
}

}  // namespace lampyris::execute
