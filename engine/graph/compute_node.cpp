#include "graph/frame.h"

namespace lampyris::graph {

ComputeNode& ComputeNode::read(uint32_t slot, Buffer buffer) {
    (void)useBuffer(buffer, {.access = Access::StorageRead, .slot = slot});
    return *this;
}

ComputeNode& ComputeNode::readRange(uint32_t slot, Buffer buffer, uint64_t offset, uint64_t bytes) {
    (void)useBuffer(
        buffer, {.access = Access::StorageRead, .slot = slot, .offset = offset, .bytes = bytes});
    return *this;
}

Buffer ComputeNode::write(uint32_t slot, Buffer buffer) {
    return useBuffer(buffer, {.access = Access::StorageWrite, .slot = slot});
}

Buffer ComputeNode::update(uint32_t slot, Buffer buffer) {
    return useBuffer(buffer, {.access = Access::StorageUpdate, .slot = slot});
}

Buffer ComputeNode::updateRange(uint32_t slot, Buffer buffer, uint64_t offset, uint64_t bytes) {
    return useBuffer(
        buffer, {.access = Access::StorageUpdate, .slot = slot, .offset = offset, .bytes = bytes});
}

ComputeNode& ComputeNode::texels(uint32_t slot, Buffer buffer, Format format) {
    (void)useBuffer(buffer, {.access = Access::TexelRead, .slot = slot, .texelFormat = format});
    return *this;
}

Buffer ComputeNode::writeTexels(uint32_t slot, Buffer buffer, Format format) {
    return useBuffer(buffer, {.access = Access::StorageWrite, .slot = slot, .texelFormat = format});
}

Buffer ComputeNode::updateTexels(uint32_t slot, Buffer buffer, Format format) {
    return useBuffer(buffer,
                     {.access = Access::StorageUpdate, .slot = slot, .texelFormat = format});
}

ComputeNode& ComputeNode::sample(uint32_t slot, Image image, Filtering filtering,
                                 Addressing addressing) {
    (void)useImage(image, {.access = Access::Sampled,
                           .slot = slot,
                           .filtering = filtering,
                           .addressing = addressing});
    return *this;
}

ComputeNode& ComputeNode::read(uint32_t slot, Image image) {
    (void)useImage(image, {.access = Access::StorageRead, .slot = slot});
    return *this;
}

Image ComputeNode::write(uint32_t slot, Image image) {
    return useImage(image, {.access = Access::StorageWrite, .slot = slot});
}

Image ComputeNode::update(uint32_t slot, Image image) {
    return useImage(image, {.access = Access::StorageUpdate, .slot = slot});
}

ComputeNode& ComputeNode::uniform(uint32_t slot, Buffer buffer) {
    (void)useBuffer(buffer, {.access = Access::Uniform, .slot = slot});
    return *this;
}

ComputeNode& ComputeNode::specialise(uint32_t id, uint32_t value) {
    node().specialisations.push_back({id, value});
    return *this;
}

void ComputeNode::dispatch(uint32_t x, uint32_t y, uint32_t z) {
    node().groups = {x, y, z};
}

void ComputeNode::dispatchOver(Extent extent) {
    const auto& size = node().shader->workgroupSize;
    dispatch((extent.width + size[0] - 1) / size[0], (extent.height + size[1] - 1) / size[1]);
}

void ComputeNode::dispatchIndirect(Buffer groups, uint64_t offset) {
    (void)useBuffer(
        groups, {.access = Access::IndirectRead, .offset = offset, .bytes = 3 * sizeof(uint32_t)});
    node().indirectResource = groups.resource;
    node().indirectOffset = offset;
}

ComputeNode& ComputeNode::storageData(uint32_t slot, const void* data, size_t bytes) {
    const auto* first = static_cast<const uint8_t*>(data);
    node().uniforms.push_back({slot, {first, first + bytes}, true});
    return *this;
}

ComputeNode& ComputeNode::uniformBytes(uint32_t slot, const void* data, size_t bytes) {
    const auto* first = static_cast<const uint8_t*>(data);
    node().uniforms.push_back({slot, {first, first + bytes}, false});
    return *this;
}

ComputeNode& ComputeNode::pushBytes(const void* data, size_t bytes) {
    const auto* first = static_cast<const uint8_t*>(data);
    node().push.assign(first, first + bytes);
    return *this;
}

}  // namespace lampyris::graph
