/// \file The bytes of a document's buffers. Private to assets.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "assets/gltf_container.h"

namespace lampyris::assets {

/// A buffer's byteLength bytes; they live in `owned` or in the GLB's bytes.
struct GltfBuffer {
    std::vector<uint8_t> owned;
    std::span<const uint8_t> bytes;
};

/// Reads all buffers. Errors: what readUri says, and a buffer longer than what it points at.
core::Result<std::vector<GltfBuffer>> readBuffers(
    const GltfContainer& container, const std::optional<std::filesystem::path>& folder,
    GltfContext& context);

}  // namespace lampyris::assets
