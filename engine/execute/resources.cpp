#include "execute/resources.h"

#include "core/check.h"
#include "execute/history_book.h"
#include "execute/transients.h"
#include "execute/translate.h"

namespace lampyris::execute {

core::Result<Resources> Resources::resolve(const graph::Frame& frame,
                                           const graph::CompiledGraph& graph,
                                           const Transients& transients,
                                           const HistoryBook& history) {
    Resources resources;
    resources.physical_.resize(frame.resources().size());
    for (uint32_t i = 0; i < frame.resources().size(); ++i) {
        if (graph.resources[i].accesses.empty()) continue;
        const graph::ResourceInfo& info = frame.resources()[i];
        Physical& physical = resources.physical_[i];
        switch (info.origin) {
            case graph::Origin::Transient:
                physical = {transients.buffer(i), transients.image(i)};
                break;
            case graph::Origin::History:
                physical.image = &history.image(info);
                break;
            case graph::Origin::Imported:
                TRY(physical, resolveImport(info));
                break;
        }
    }
    return resources;
}

core::Result<Resources::Physical> Resources::resolveImport(const graph::ResourceInfo& info) {
    if (info.external.object == nullptr)
        return core::error("imported {} has no object behind it", info.name);
    Physical physical;
    if (!info.isImage) {
        physical.buffer = static_cast<const gpu::Buffer*>(info.external.object);
        if (physical.buffer->bytes() < info.buffer.bytes)
            return core::error("imported buffer {}: described as {} bytes, has {}", info.name,
                               info.buffer.bytes, physical.buffer->bytes());
        return physical;
    }
    physical.image = static_cast<const gpu::Image*>(info.external.object);
    const gpu::ImageOptions& options = physical.image->options();
    if (options.format != formatOf(info.image.format) ||
        options.extent.width != info.image.extent.width ||
        options.extent.height != info.image.extent.height || options.layers != info.image.layers)
        return core::error("imported image {}: is {} x {} with {} layers, not as described",
                           info.name, options.extent.width, options.extent.height, options.layers);
    return physical;
}

const gpu::Buffer& Resources::buffer(uint32_t resource) const {
    CHECK((physical_[resource].buffer != nullptr) == true);
    return *physical_[resource].buffer;
}

const gpu::Image& Resources::image(uint32_t resource) const {
    CHECK((physical_[resource].image != nullptr) == true);
    return *physical_[resource].image;
}

}  // namespace lampyris::execute
