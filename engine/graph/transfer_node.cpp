#include "graph/frame.h"

namespace lampyris::graph {
namespace {

uint64_t tightBytes(const ImageDesc& desc) {
    return uint64_t{bytesPerTexel(desc.format)} * desc.extent.width * desc.extent.height *
           desc.layers;
}

}  // namespace

Buffer TransferNode::fill(Buffer buffer, uint32_t value) {
    node().copies.push_back({.kind = Copy::Kind::Fill,
                             .sourceResource = buffer.resource,
                             .targetResource = buffer.resource,
                             .bytes = sizeOf(buffer),
                             .fillValue = value});
    return useBuffer(buffer, {.access = Access::TransferWrite});
}

Buffer TransferNode::copy(Buffer source, uint64_t sourceOffset, Buffer target,
                          uint64_t targetOffset, uint64_t bytes) {
    node().copies.push_back({.kind = Copy::Kind::BufferToBuffer,
                             .sourceResource = source.resource,
                             .targetResource = target.resource,
                             .sourceOffset = sourceOffset,
                             .targetOffset = targetOffset,
                             .bytes = bytes});
    (void)useBuffer(source,
                    {.access = Access::TransferRead, .offset = sourceOffset, .bytes = bytes});
    return useBuffer(target, {.access = Access::TransferWrite,
                              .offset = targetOffset,
                              .bytes = bytes,
                              .partial = targetOffset != 0 || bytes != sizeOf(target)});
}

Image TransferNode::copy(Image source, Image target) {
    node().copies.push_back({.kind = Copy::Kind::ImageToImage,
                             .sourceResource = source.resource,
                             .targetResource = target.resource});
    (void)useImage(source, {.access = Access::TransferRead});
    return useImage(target, {.access = Access::TransferWrite});
}

Buffer TransferNode::copyToBuffer(Image source, Buffer target) {
    const uint64_t bytes = source.resource < frame_->resources().size()
                               ? tightBytes(frame_->resources()[source.resource].image)
                               : 0;
    node().copies.push_back({.kind = Copy::Kind::ImageToBuffer,
                             .sourceResource = source.resource,
                             .targetResource = target.resource,
                             .bytes = bytes});
    (void)useImage(source, {.access = Access::TransferRead});
    return useBuffer(
        target,
        {.access = Access::TransferWrite, .bytes = bytes, .partial = bytes != sizeOf(target)});
}

Image TransferNode::copyToImage(Buffer source, uint64_t sourceOffset, Image target,
                                uint32_t layer) {
    const ImageDesc desc = target.resource < frame_->resources().size()
                               ? frame_->resources()[target.resource].image
                               : ImageDesc{};
    const uint64_t bytes = desc.layers == 0 ? 0 : tightBytes(desc) / desc.layers;
    node().copies.push_back({.kind = Copy::Kind::BufferToImage,
                             .sourceResource = source.resource,
                             .targetResource = target.resource,
                             .sourceOffset = sourceOffset,
                             .bytes = bytes,
                             .targetLayer = layer});
    (void)useBuffer(source,
                    {.access = Access::TransferRead, .offset = sourceOffset, .bytes = bytes});
    return useImage(target, {.access = Access::TransferWrite, .partial = desc.layers > 1});
}

Image TransferNode::blit(Image source, Image target) {
    node().copies.push_back({.kind = Copy::Kind::Blit,
                             .sourceResource = source.resource,
                             .targetResource = target.resource});
    (void)useImage(source, {.access = Access::TransferRead});
    return useImage(target, {.access = Access::TransferWrite});
}

uint64_t TransferNode::sizeOf(Buffer buffer) const {
    const auto& resources = frame_->resources();
    return buffer.resource < resources.size() ? resources[buffer.resource].buffer.bytes : 0;
}

}  // namespace lampyris::graph
