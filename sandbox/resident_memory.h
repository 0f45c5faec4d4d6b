/// \file How much memory the process holds.
#pragma once

#include <cstdint>

namespace lampyris::sandbox {

/// Bytes of this process in physical memory; 0 where the system does not tell.
[[nodiscard]] uint64_t residentBytes();

}  // namespace lampyris::sandbox
