#include <algorithm>

#include "graph/compile.h"

namespace lampyris::graph {
namespace {

constexpr uint64_t kAlignment = 256;  // [chosen] the strictest that Vulkan's buffer limits may ask

}  // namespace

MemoryNeed MemoryModel::image(const ImageDesc& desc, AccessSet) const {
    const uint64_t texels = uint64_t{desc.extent.width} * desc.extent.height * desc.layers;
    return {.bytes = texels * bytesPerTexel(desc.format), .alignment = kAlignment};
}

MemoryNeed MemoryModel::buffer(const BufferDesc& desc, AccessSet) const {
    return {.bytes = desc.bytes, .alignment = kAlignment};
}

}  // namespace lampyris::graph
