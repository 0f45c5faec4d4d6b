#include "execute/transients.h"

#include "execute/memory_model.h"
#include "execute/translate.h"

namespace lampyris::execute {

bool Transients::wouldChange(const graph::CompiledGraph& graph) const {
    return layoutHash_ != graph.layoutHash;
}

core::Result<void> Transients::follow(const graph::Frame& frame,
                                      const graph::CompiledGraph& graph) {
    const bool anew = wouldChange(graph);
    if (anew) {
        layoutHash_.reset();
        physical_.clear();
        heaps_.clear();
        TRY_VOID(makeHeaps(graph));
    }
    places_.assign(graph.resources.size(), kNone);
    size_t place = 0;
    for (size_t i = 0; i < graph.resources.size(); ++i) {
        if (graph.resources[i].heap == graph::kNoHeap) continue;
        if (anew) TRY_VOID(makeResource(frame.resources()[i], graph.resources[i]));
        places_[i] = place++;
    }
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
                                            const graph::CompiledResource& compiled) {
    const gpu::Allocation& heap = heaps_[compiled.heap];
    Physical made;
    if (info.isImage) {
        TRY(made.image,
            gpu::Image::createUnbound(
                *device_, imageOptionsOf(info.image, imageUsageOf(compiled.accesses), info.name)));
        TRY_VOID(made.image.bind(heap, compiled.offset));
    } else {
        TRY(made.buffer,
            gpu::Buffer::createUnbound(*device_, {.bytes = info.buffer.bytes, .name = info.name}));
        TRY_VOID(made.buffer.bind(heap, compiled.offset));
    }
    physical_.push_back(std::move(made));
    return {};
}

const gpu::Buffer* Transients::buffer(size_t resource) const {
    const size_t place = places_[resource];
    if (place == kNone || physical_[place].buffer.get() == VK_NULL_HANDLE) return nullptr;
    return &physical_[place].buffer;
}

const gpu::Image* Transients::image(size_t resource) const {
    const size_t place = places_[resource];
    if (place == kNone || physical_[place].image.get() == VK_NULL_HANDLE) return nullptr;
    return &physical_[place].image;
}

}  // namespace lampyris::execute
