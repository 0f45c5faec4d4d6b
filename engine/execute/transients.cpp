#include "execute/transients.h"

#include "execute/memory_model.h"
#include "execute/translate.h"

namespace lampyris::execute {

bool Transients::wouldChange(const graph::CompiledGraph& graph) const {
    return layoutHash_ != graph.layoutHash;
}

core::Result<void> Transients::follow(const graph::Frame& frame,
                                      const graph::CompiledGraph& graph) {
    if (!wouldChange(graph)) return {};
    layoutHash_.reset();
    buffers_.clear();
    images_.clear();
    heaps_.clear();
    TRY_VOID(makeHeaps(graph));
    for (uint32_t i = 0; i < graph.resources.size(); ++i)
        if (graph.resources[i].heap != graph::kNoHeap)
            TRY_VOID(makeResource(frame.resources()[i], graph.resources[i], i));
    layoutHash_ = graph.layoutHash;
    return {};
}

core::Result<void> Transients::makeHeaps(const graph::CompiledGraph& graph) {
    for (const graph::Heap& heap : graph.heaps) {
        const VkMemoryRequirements needs{heap.bytes, heap.alignment,
                                         DeviceMemoryModel::typeBits(heap.memoryKind)};
        const bool linear = !DeviceMemoryModel::holdsImages(heap.memoryKind);
        TRY(gpu::Allocation memory,
            device_->memory().allocate(needs, gpu::MemoryUse::Device, linear, "transient heap"));
        heaps_.push_back(std::move(memory));
    }
    return {};
}

core::Result<void> Transients::makeResource(const graph::ResourceInfo& info,
                                            const graph::CompiledResource& compiled,
                                            uint32_t resource) {
    const gpu::Allocation& heap = heaps_[compiled.heap];
    if (info.isImage) {
        TRY(gpu::Image image,
            gpu::Image::createUnbound(
                *device_, imageOptionsOf(info.image, imageUsageOf(compiled.accesses), info.name)));
        TRY_VOID(image.bind(heap, compiled.offset));
        images_.emplace(resource, std::move(image));
        return {};
    }
    TRY(gpu::Buffer buffer,
        gpu::Buffer::createUnbound(*device_, {.bytes = info.buffer.bytes, .name = info.name}));
    TRY_VOID(buffer.bind(heap, compiled.offset));
    buffers_.emplace(resource, std::move(buffer));
    return {};
}

const gpu::Buffer* Transients::buffer(uint32_t resource) const {
    const auto found = buffers_.find(resource);
    return found == buffers_.end() ? nullptr : &found->second;
}

const gpu::Image* Transients::image(uint32_t resource) const {
    const auto found = images_.find(resource);
    return found == images_.end() ? nullptr : &found->second;
}

}  // namespace lampyris::execute
