/// \file What the graph knows of a shader: its SPIR-V words and the slots that reflection found in
/// it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace lampyris::graph {

enum class SlotKind : uint8_t {
    StorageBuffer,
    UniformBuffer,
    UniformTexelBuffer,
    StorageTexelBuffer,
    SampledImage,  ///< combined image sampler
    StorageImage,
};

/// One binding of set 0. `writes` is false where the shader declares it readonly.
struct ShaderSlot {
    std::string_view name{};
    uint32_t slot = 0;
    SlotKind kind = SlotKind::StorageBuffer;
    bool reads = true;
    bool writes = false;
};

/// A compiled shader, embedded at build time. Compared by address: keep one object a shader.
struct Shader {
    std::string_view name{};  ///< "photon_gi/tile_bin_count.comp"
    std::span<const uint32_t> words{};
    std::span<const ShaderSlot> slots{};
    std::array<uint32_t, 3> workgroupSize{1, 1, 1};  ///< compute only
    uint32_t pushConstantBytes = 0;
    std::string_view source{};  ///< its file, below the shaders' folder; empty: none is known
    std::span<const std::string_view> definitions{};  ///< that it was compiled with: "MASKED=1"
};

}  // namespace lampyris::graph
