#include "graph/verify.h"

namespace lampyris::graph {
namespace {

core::Result<void> notEmpty(const Node& node, const ResourceInfo& info) {
    const ImageDesc& image = info.image;
    const bool empty = info.isImage ? image.extent.width == 0 || image.extent.height == 0 ||
                                          image.layers == 0 || image.format == Format::Undefined
                                    : info.buffer.bytes == 0;
    if (!empty) return {};
    return core::error("render graph: node '{}' uses '{}', {} of size zero or without a format",
                       node.name, info.name, info.isImage ? "an image" : "a buffer");
}

core::Result<void> rangeFits(const Node& node, const ResourceInfo& info, const Use& use) {
    const uint64_t size = info.buffer.bytes;
    if (use.offset < size && use.bytes <= size - use.offset) return {};
    return core::error("render graph: node '{}' uses bytes {} to {} of buffer '{}', which has {}",
                       node.name, use.offset, use.offset + use.bytes, info.name, size);
}

core::Result<void> texelsFit(const Node& node, const ResourceInfo& info, const Use& use) {
    const uint32_t texel = bytesPerTexel(use.texelFormat);
    if (use.texelFormat == Format::Undefined && use.access != Access::TexelRead) return {};
    if (texel != 0 && info.buffer.bytes % texel == 0) return {};
    return core::error(
        "render graph: node '{}' uses buffer '{}' of {} bytes as texels of {} ({} bytes)",
        node.name, info.name, info.buffer.bytes, name(use.texelFormat), texel);
}

core::Result<void> attachmentFits(const Node& node, const ResourceInfo& info, const Use& use) {
    const bool colour = use.access == Access::ColorWrite;
    const bool depth = use.access == Access::DepthWrite || use.access == Access::DepthRead;
    if (!colour && !depth) return {};
    if (isDepth(info.image.format) != depth) {
        return core::error("render graph: node '{}' has '{}' ({}) as {} attachment", node.name,
                           info.name, name(info.image.format), colour ? "colour" : "depth");
    }
    const Extent& size = info.image.extent;
    if (size.width >= node.renderExtent.width && size.height >= node.renderExtent.height) return {};
    return core::error("render graph: node '{}' draws {}x{} into '{}', which has {}x{}", node.name,
                       node.renderExtent.width, node.renderExtent.height, info.name, size.width,
                       size.height);
}

core::Result<void> copyFits(const Frame& frame, const Node& node, const Copy& copy) {
    const ResourceInfo& source = frame.resources()[copy.sourceResource];
    const ResourceInfo& target = frame.resources()[copy.targetResource];
    if (copy.kind == Copy::Kind::Fill && target.buffer.bytes % 4 != 0) {
        return core::error(
            "render graph: node '{}' fills buffer '{}' of {} bytes, not a multiple of 4", node.name,
            target.name, target.buffer.bytes);
    }
    if (copy.kind == Copy::Kind::ImageToImage && source.image != target.image) {
        return core::error(
            "render graph: node '{}' copies image '{}' into '{}' of another size or format",
            node.name, source.name, target.name);
    }
    if (copy.kind == Copy::Kind::BufferToImage && copy.targetLayer >= target.image.layers) {
        return core::error("render graph: node '{}' copies to layer {} of image '{}', which has {}",
                           node.name, copy.targetLayer, target.name, target.image.layers);
    }
    return {};
}

}  // namespace

core::Result<void> verifySizes(const Frame& frame, const Node& node) {
    for (const Use& use : node.uses) {
        const ResourceInfo& info = frame.resources()[use.resource];
        TRY_VOID(notEmpty(node, info));
        if (use.isImage) {
            TRY_VOID(attachmentFits(node, info, use));
        } else {
            TRY_VOID(rangeFits(node, info, use));
            TRY_VOID(texelsFit(node, info, use));
        }
    }
    for (const Copy& copy : node.copies) TRY_VOID(copyFits(frame, node, copy));
    return {};
}

}  // namespace lampyris::graph
