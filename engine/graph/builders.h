/// \file What a node may declare: one builder a kind of node, handed out by Frame.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <type_traits>
#include <vector>

#include "graph/node.h"
#include "graph/resource.h"

namespace lampyris::graph {

class Frame;

/// Shared part of the three kinds of node builders. A builder is a short-lived view of the node in
/// its Frame.
class NodeBuilder {
 public:
    NodeBuilder(Frame& frame, uint32_t node) : frame_(&frame), node_(node) {}
    /// The node has an effect outside the graph and is never culled.
    void keep();

 protected:
    [[nodiscard]] Node& node();
    void use(const Use& use);
    [[nodiscard]] Image useImage(Image image, Use use);
    [[nodiscard]] Buffer useBuffer(Buffer buffer, Use use);
    Frame* frame_;
    uint32_t node_;
};

/// A compute dispatch. Each call names a slot of shaders/shared/…; reflection must agree with it.
class ComputeNode : public NodeBuilder {
 public:
    using NodeBuilder::NodeBuilder;
    ComputeNode& read(uint32_t slot, Buffer buffer);  ///< storage buffer, readonly
    ComputeNode& readRange(uint32_t slot, Buffer buffer, uint64_t offset, uint64_t bytes);
    [[nodiscard]] Buffer write(uint32_t slot, Buffer buffer);   ///< what it held is lost
    [[nodiscard]] Buffer update(uint32_t slot, Buffer buffer);  ///< read and written in place
    [[nodiscard]] Buffer updateRange(uint32_t slot, Buffer buffer, uint64_t offset, uint64_t bytes);
    ComputeNode& texels(uint32_t slot, Buffer buffer, Format format);  ///< uniform texel buffer
    /// Storage texel buffers: what it held is lost, or stays where the shader writes nothing.
    [[nodiscard]] Buffer writeTexels(uint32_t slot, Buffer buffer, Format format);
    [[nodiscard]] Buffer updateTexels(uint32_t slot, Buffer buffer, Format format);
    ComputeNode& sample(uint32_t slot, Image image, Filtering filtering = Filtering::Nearest,
                        Addressing addressing = Addressing::Clamp);
    ComputeNode& read(uint32_t slot, Image image);  ///< storage image, readonly
    [[nodiscard]] Image write(uint32_t slot, Image image);
    [[nodiscard]] Image update(uint32_t slot, Image image);
    ComputeNode& uniform(uint32_t slot, Buffer buffer);
    template <typename T>
    ComputeNode& uniformData(uint32_t slot, const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        return uniformBytes(slot, &value, sizeof(T));
    }
    /// Readonly storage buffer with data of this frame: uniformData without its size limit.
    ComputeNode& storageData(uint32_t slot, const void* data, size_t bytes);
    template <typename T>
    ComputeNode& push(const T& value) {
        static_assert(std::is_trivially_copyable_v<T> && sizeof(T) <= 128);
        return pushBytes(&value, sizeof(T));
    }
    ComputeNode& specialise(uint32_t id, uint32_t value);
    /// Workgroups. The last call of the declaration.
    void dispatch(uint32_t x, uint32_t y = 1, uint32_t z = 1);
    /// Enough workgroups of the shader's own size to cover the extent.
    void dispatchOver(Extent extent);
    /// Three uint32 group counts at an offset of a buffer.
    void dispatchIndirect(Buffer groups, uint64_t offset = 0);

 private:
    ComputeNode& uniformBytes(uint32_t slot, const void* data, size_t bytes);
    ComputeNode& pushBytes(const void* data, size_t bytes);
};

/// Draws with dynamic rendering. The slots of both shaders form one set.
class RasterNode : public NodeBuilder {
 public:
    using NodeBuilder::NodeBuilder;
    [[nodiscard]] Image colour(uint32_t location, Image image);  ///< loads what is there
    [[nodiscard]] Image clearedColour(uint32_t location, Image image,
                                      std::array<float, 4> colour = {});
    [[nodiscard]] Image clearedColourUint(uint32_t location, Image image, uint32_t value = 0);
    [[nodiscard]] Image depth(Image image);
    [[nodiscard]] Image clearedDepth(Image image, float value = 0.0f);
    RasterNode& testDepth(Image image);  ///< tested, not written
    RasterNode& vertices(Buffer buffer);
    RasterNode& indices(Buffer buffer);
    RasterNode& read(uint32_t slot, Buffer buffer);
    RasterNode& texels(uint32_t slot, Buffer buffer, Format format);
    RasterNode& sample(uint32_t slot, Image image, Filtering filtering = Filtering::Nearest,
                       Addressing addressing = Addressing::Clamp);
    /// Readonly storage buffer with data of this frame: uniformData without its size limit.
    RasterNode& storageData(uint32_t slot, const void* data, size_t bytes);
    template <typename T>
    RasterNode& uniformData(uint32_t slot, const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        return uniformBytes(slot, &value, sizeof(T));
    }
    /// Shaders the callback will use, and the callback. The last call of the declaration.
    void record(std::vector<const Shader*> shaders, std::function<void(RasterCommands&)> callback);

 private:
    RasterNode& uniformBytes(uint32_t slot, const void* data, size_t bytes);
};

/// Copies and fills, in the order given; one node may rewrite a target several times. A copy that
/// covers a part of its target keeps the rest, which must have been written (by this node's other
/// copies, say).
class TransferNode : public NodeBuilder {
 public:
    using NodeBuilder::NodeBuilder;
    [[nodiscard]] Buffer fill(Buffer buffer, uint32_t value);
    [[nodiscard]] Buffer copy(Buffer source, uint64_t sourceOffset, Buffer target,
                              uint64_t targetOffset, uint64_t bytes);
    [[nodiscard]] Image copy(Image source, Image target);
    [[nodiscard]] Buffer copyToBuffer(Image source, Buffer target);
    [[nodiscard]] Image copyToImage(Buffer source, uint64_t sourceOffset, Image target,
                                    uint32_t layer = 0);
    [[nodiscard]] Image blit(Image source, Image target);

 private:
    [[nodiscard]] uint64_t sizeOf(Buffer buffer) const;
};

}  // namespace lampyris::graph
