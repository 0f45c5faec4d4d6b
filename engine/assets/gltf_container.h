/// \file The outermost layer of a file: GLB chunks or plain JSON. Private to assets.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "assets/gltf_context.h"
#include "assets/gltf_json.h"

namespace lampyris::assets {

struct GltfContainer {
    Json json;                                       ///< an object
    std::optional<std::span<const uint8_t>> binary;  ///< the GLB's BIN chunk, into the file's bytes
};

/// Takes a file apart. Errors: cut or inconsistent GLB headers and chunks, bytes that are no JSON,
/// JSON nested deeper than kDeepestNesting.
core::Result<GltfContainer> openContainer(std::span<const uint8_t> bytes,
                                          const GltfContext& context);

/// [chosen] ten times what glTF itself needs; tinygltf recurses through extras.
constexpr size_t kDeepestNesting = 128;

}  // namespace lampyris::assets
