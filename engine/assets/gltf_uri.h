/// \file What a URI of a glTF file points at: bytes inside it, or a file beside it. Private to
/// assets.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"

namespace lampyris::assets {

/// A URI made sense of: data, or a path relative to the glTF file's folder.
struct GltfUri {
    bool isData = false;
    std::filesystem::path path;
};

/// Errors (without name or place): a scheme other than data:, an absolute path, one that leaves the
/// folder, a bad escape.
core::Result<GltfUri> parseUri(const std::string& uri);

/// The bytes of a URI. Errors (without name or place): as above, a data: URI that is no base64, a
/// file that is missing or no plain file, no folder to look in.
core::Result<std::vector<uint8_t>> readUri(const std::string& uri,
                                           const std::optional<std::filesystem::path>& folder);

}  // namespace lampyris::assets
