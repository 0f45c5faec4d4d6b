/// \file What stb_image does not look at in a PNG file: whether its bytes are those once written.
#pragma once

#include <cstdint>
#include <span>

#include "core/result.h"

namespace lampyris::core {

/// The signature, and every chunk whole, with the checksum that it states, up to the last. Errors
/// do not name the file.
Result<void> checkPng(std::span<const uint8_t> bytes);

}  // namespace lampyris::core
