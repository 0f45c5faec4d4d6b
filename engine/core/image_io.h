/// \file EXR (32-bit float, RGB) and PNG (8-bit sRGB) files.
#pragma once

#include <filesystem>

#include "core/display.h"
#include "core/image.h"
#include "core/result.h"

namespace lampyris::core {

/// Linear EXR; one channel is written to all of R, G and B, a fourth is dropped. Never
/// half-written.
Result<void> writeExr(const std::filesystem::path& path, const Image& image);
/// A scan-line EXR file as a linear image of three channels: R, G and B, or Y in all three; half or
/// float; the data window alone. Tiles, deep data and several parts are errors.
Result<Image> readExr(const std::filesystem::path& path);

Result<void> writePng(const std::filesystem::path& path, const DisplayImage& image);
/// A PNG file as 8-bit values; alpha is dropped, grey is spread. A file that is cut or damaged is
/// an error.
Result<DisplayImage> readPng(const std::filesystem::path& path);

/// By the file's ending: .exr as it is, .png through the display transform; any other is an error.
Result<void> writeImage(const std::filesystem::path& path, const Image& image,
                        const DisplayTransform& transform);

}  // namespace lampyris::core
