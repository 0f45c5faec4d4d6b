/// \file What tinyexr takes on trust in an EXR file, checked before it decodes any of it.
#pragma once

#include <tinyexr.h>

#include <cstdint>
#include <span>

#include "core/result.h"

namespace lampyris::core {

/// One flat scan-line picture: no tiles, no deep data, no parts. To be called before tinyexr parses
/// the header. Errors do not name the file.
Result<void> checkExrKind(std::span<const uint8_t> bytes);

/// A size that can be drawn, known compression and samples, and every block of rows in its place
/// within the file. To be called before tinyexr decodes the pixels. Errors do not name the file.
Result<void> checkExrLayout(std::span<const uint8_t> bytes, const EXRHeader& header);

}  // namespace lampyris::core
