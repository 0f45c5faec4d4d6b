#include <bit>

#include "graph/frame.h"

namespace lampyris::graph {

Image RasterNode::colour(uint32_t location, Image image) {
    return useImage(image, {.access = Access::ColorWrite, .slot = location});
}

Image RasterNode::clearedColour(uint32_t location, Image image, std::array<float, 4> colour) {
    return useImage(
        image,
        {.access = Access::ColorWrite, .slot = location, .clears = true, .clearColour = colour});
}

Image RasterNode::clearedColourUint(uint32_t location, Image image, uint32_t value) {
    const auto bits = std::bit_cast<float>(value);
    return useImage(image, {.access = Access::ColorWrite,
                            .slot = location,
                            .clears = true,
                            .clearColour = {bits, bits, bits, bits},
                            .clearsAsUint = true});
}

Image RasterNode::depth(Image image) {
    return useImage(image, {.access = Access::DepthWrite});
}

Image RasterNode::clearedDepth(Image image, float value) {
    return useImage(image, {.access = Access::DepthWrite, .clears = true, .clearColour = {value}});
}

RasterNode& RasterNode::testDepth(Image image) {
    (void)useImage(image, {.access = Access::DepthRead});
    return *this;
}

RasterNode& RasterNode::vertices(Buffer buffer) {
    (void)useBuffer(buffer, {.access = Access::VertexRead});
    return *this;
}

RasterNode& RasterNode::indices(Buffer buffer) {
    (void)useBuffer(buffer, {.access = Access::IndexRead});
    return *this;
}

RasterNode& RasterNode::read(uint32_t slot, Buffer buffer) {
    (void)useBuffer(buffer, {.access = Access::StorageRead, .slot = slot});
    return *this;
}

RasterNode& RasterNode::texels(uint32_t slot, Buffer buffer, Format format) {
    (void)useBuffer(buffer, {.access = Access::TexelRead, .slot = slot, .texelFormat = format});
    return *this;
}

RasterNode& RasterNode::sample(uint32_t slot, Image image, Filtering filtering,
                               Addressing addressing) {
    (void)useImage(image, {.access = Access::Sampled,
                           .slot = slot,
                           .filtering = filtering,
                           .addressing = addressing});
    return *this;
}

void RasterNode::record(std::vector<const Shader*> shaders,
                        std::function<void(RasterCommands&)> callback) {
    node().rasterShaders = std::move(shaders);
    node().record = std::move(callback);
}

RasterNode& RasterNode::storageData(uint32_t slot, const void* data, size_t bytes) {
    const auto* first = static_cast<const uint8_t*>(data);
    node().uniforms.push_back({slot, {first, first + bytes}, true});
    return *this;
}

RasterNode& RasterNode::uniformBytes(uint32_t slot, const void* data, size_t bytes) {
    const auto* first = static_cast<const uint8_t*>(data);
    node().uniforms.push_back({slot, {first, first + bytes}, false});
    return *this;
}

}  // namespace lampyris::graph
