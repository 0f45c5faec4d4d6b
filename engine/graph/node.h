/// \file What a node declares: every access with its slot, so that access and binding cannot
/// disagree.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "graph/access.h"
#include "graph/resource.h"
#include "graph/shader.h"

namespace lampyris::graph {

class Frame;

constexpr uint32_t kNoSlot = 0xffffffffu;

enum class Filtering : uint8_t { Nearest, Linear };
enum class Addressing : uint8_t { Clamp, Repeat };

/// One declared access of a node: which version, how, and in which shader slot.
struct Use {
    bool isImage = false;
    uint32_t resource = 0;
    uint32_t version = 0;         ///< read (or, for a pure write, the version retired)
    uint32_t writtenVersion = 0;  ///< the successor, where the access writes
    Access access = Access::None;
    uint32_t slot = kNoSlot;  ///< shader slot; for ColorWrite the attachment's location
    Format texelFormat = Format::Undefined;  ///< for texel buffers
    Filtering filtering = Filtering::Nearest;
    Addressing addressing = Addressing::Clamp;
    uint64_t offset = 0;   ///< buffers: first byte bound (texel buffers: a multiple of 256)
    uint64_t bytes = 0;    ///< buffers: 0 is up to the end
    bool partial = false;  ///< transfers: writes a part, the rest of the contents stays
    bool clears = false;   ///< attachments: cleared at load
    std::array<float, 4> clearColour{};  ///< colour, or depth in [0]
    bool clearsAsUint = false;           ///< clearColour holds the bits of four uint32
};

struct VertexAttribute {
    uint32_t location = 0;
    uint32_t stream = 0;      ///< index of the vertex buffer
    uint32_t components = 3;  ///< floats, 1 to 4
    uint32_t strideBytes = 12;
};

/// Fixed-function state of a draw; both sides are always drawn unless `cullBack`.
struct RasterPipeline {
    const Shader* vertex = nullptr;
    const Shader* fragment = nullptr;
    std::vector<VertexAttribute> attributes;
    bool depthTest = true;  ///< reversed: greater or equal passes
    bool depthWrite = true;
    bool depthEqual = false;  ///< what is tested passes only where it is equal
    bool lines = false;
    bool blend =
        false;  ///< over what is there, by the fragment's alpha; its colour is not multiplied
};

/// Pixels from the top left.
struct Rectangle {
    uint32_t x = 0, y = 0;
    uint32_t width = 0, height = 0;
};

/// One draw. Buffers must have been declared by the node. Not indexed where `indices` is invalid.
struct Draw {
    const RasterPipeline* pipeline = nullptr;
    std::vector<Buffer> streams;
    std::vector<uint64_t> streamOffsets;
    Buffer indices;  ///< 32-bit
    uint64_t indexOffsetBytes = 0;
    uint32_t count = 0;  ///< indices or vertices
    uint32_t instances = 1;
    std::optional<Rectangle> scissor{};  ///< within the node's extent; all of it where left out
    std::array<uint8_t, 128> push{};
    uint32_t pushBytes = 0;

    template <typename T>
    void pushConstants(const T& value) {
        static_assert(std::is_trivially_copyable_v<T> && sizeof(T) <= 128);
        std::memcpy(push.data(), &value, sizeof(T));
        pushBytes = sizeof(T);
    }
};

/// Given to a raster node's record callback; takes only what that node declared.
class RasterCommands {
 public:
    virtual ~RasterCommands() = default;
    virtual void draw(const Draw& draw) = 0;
};

/// A copy between declared buffers or images.
struct Copy {
    enum class Kind : uint8_t {
        BufferToBuffer,
        ImageToImage,
        ImageToBuffer,
        BufferToImage,
        Fill,
        Blit
    };
    Kind kind = Kind::BufferToBuffer;
    uint32_t sourceResource = 0;
    uint32_t targetResource = 0;
    uint64_t sourceOffset = 0;
    uint64_t targetOffset = 0;
    uint64_t bytes = 0;  ///< buffers
    uint32_t fillValue = 0;
    uint32_t targetLayer = 0;
};

/// A value for a shader's specialization constant.
struct Specialisation {
    uint32_t id = 0;
    uint32_t value = 0;
};

/// Small data of this frame, bound as a uniform (or readonly storage) buffer; the executor places
/// it.
struct UniformData {
    uint32_t slot = 0;
    std::vector<uint8_t> bytes;
    bool storage = false;  ///< bound as a storage buffer: more than a uniform buffer may hold
};

/// Everything a node said of itself.
struct Node {
    std::string name;
    NodeKind kind = NodeKind::Compute;
    const Shader* shader = nullptr;  ///< compute
    std::vector<Use> uses;
    std::vector<UniformData> uniforms;
    std::vector<uint8_t> push;
    std::vector<Specialisation> specialisations;
    std::array<uint32_t, 3> groups{1, 1, 1};
    std::optional<uint32_t> indirectResource;
    uint64_t indirectOffset = 0;
    std::function<void(RasterCommands&)> record;  ///< raster
    Extent renderExtent;                          ///< raster
    std::vector<const Shader*> rasterShaders;     ///< raster: for the check of declared writes
    std::vector<Copy> copies;                     ///< transfer
    bool keep = false;                            ///< has an effect outside the graph: never culled
};

}  // namespace lampyris::graph
