/// \file Images and buffers as the graph sees them: descriptions and versioned handles.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace lampyris::graph {

enum class Format : uint8_t {
    Undefined,
    R32Uint,
    R32Float,
    RG32Float,
    RGBA8Unorm,
    RGBA8Srgb,
    BGRA8Unorm,
    RGBA16Float,
    RGBA32Float,
    RGBA32Uint,
    D32Float,
};

[[nodiscard]] uint32_t bytesPerTexel(Format format);
[[nodiscard]] uint32_t channels(Format format);  ///< 1, 2 or 4; 0 of Undefined
[[nodiscard]] const char* name(Format format);
[[nodiscard]] inline bool isDepth(Format format) {
    return format == Format::D32Float;
}

struct Extent {
    uint32_t width = 1;
    uint32_t height = 1;
    bool operator==(const Extent&) const = default;
    /// The size at a divisor an axis, rounded up.
    [[nodiscard]] Extent dividedBy(uint32_t divisor) const {
        return {(width + divisor - 1) / divisor, (height + divisor - 1) / divisor};
    }
};

struct ImageDesc {
    Format format = Format::Undefined;
    Extent extent;
    uint32_t layers = 1;  ///< above 1: a 2D array
    bool array = false;   ///< shaders see an array even with one layer
    bool operator==(const ImageDesc&) const = default;
};

struct BufferDesc {
    uint64_t bytes = 0;
    bool operator==(const BufferDesc&) const = default;
};

/// A version of an image of one Frame. A node that writes it retires it and gives back its
/// successor.
struct Image {
    uint32_t resource = 0xffffffffu;
    uint32_t version = 0;
    [[nodiscard]] bool valid() const { return resource != 0xffffffffu; }
    bool operator==(const Image&) const = default;
};

/// A version of a buffer of one Frame, as Image.
struct Buffer {
    uint32_t resource = 0xffffffffu;
    uint32_t version = 0;
    [[nodiscard]] bool valid() const { return resource != 0xffffffffu; }
    bool operator==(const Buffer&) const = default;
};

/// A thing that lives outside the graph (a gpu::Image or gpu::Buffer); only execute/ looks inside.
struct External {
    const void* object = nullptr;
};

}  // namespace lampyris::graph
