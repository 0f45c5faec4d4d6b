/// \file A frame as a file.
#pragma once

#include <filesystem>

#include "core/image.h"
#include "core/result.h"

namespace lampyris::sandbox::view {

/// The path, or where there is such a file the first of a_2.png, a_3.png, … that there is not.
[[nodiscard]] std::filesystem::path freePath(const std::filesystem::path& wanted);

/// Writes a PNG of an image that is encoded for the display; its alpha is left out.
core::Result<void> writeScreenshot(const std::filesystem::path& path, const core::Image& image);

}  // namespace lampyris::sandbox::view
