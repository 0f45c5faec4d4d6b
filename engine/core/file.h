/// \file Whole files in and out. A file is written beside its name and then renamed: never
/// half-written.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace lampyris::core {

/// All bytes of a file, or an error that names it.
Result<std::vector<uint8_t>> readFile(const std::filesystem::path& path);

/// Replaces the file in one step; on an error the old file stands as it was.
Result<void> writeFile(const std::filesystem::path& path, std::span<const uint8_t> bytes);
Result<void> writeFile(const std::filesystem::path& path, std::string_view text);

}  // namespace lampyris::core
