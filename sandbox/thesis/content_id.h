/// \file Short names for what bytes hold: the same bytes, the same name.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/image.h"
#include "core/result.h"

namespace lampyris::sandbox::thesis {

/// Sixteen hexadecimal digits (FNV-1a).
[[nodiscard]] std::string idOf(std::span<const uint8_t> bytes);
[[nodiscard]] std::string idOf(const std::string& text);
[[nodiscard]] std::string idOf(const core::Image& image);

/// Of the program that runs, so that what another build measured is not mistaken for its own.
core::Result<std::string> programId();

}  // namespace lampyris::sandbox::thesis
