/// \file glTF 2.0 files (.gltf with what lies beside it, .glb) into a Model.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "assets/model.h"
#include "core/result.h"

namespace lampyris::assets {

/// What a file may ask of memory before it is refused.
struct GltfLimits {
    uint64_t decodedBytes = uint64_t{4} << 30;  ///< meshes, animations and images together [chosen]
    uint32_t imageSide = 16384;  ///< texels [chosen: the largest 2D image of common devices]
};

/// Reads a file. What cannot be drawn as meant (a corrupt image, points and lines, a sheared matrix
/// …) is a warning on the log; what breaks the format is an error that names the file and the JSON
/// place.
core::Result<Model> loadGltf(const std::filesystem::path& path, const GltfLimits& limits = {});

/// The same from memory. `name` stands in messages; without a base directory, files beside it are
/// errors.
core::Result<Model> parseGltf(
    std::span<const uint8_t> bytes, const std::string& name,
    const std::optional<std::filesystem::path>& baseDirectory = std::nullopt,
    const GltfLimits& limits = {});

}  // namespace lampyris::assets
