/// \file Work shared out over threads.
#pragma once

#include <cstdint>
#include <functional>

namespace lampyris::reference {

/// Calls visit(i) once for each i below `count`, on so many threads (0: one a core), and waits for
/// them all. Which thread takes which is left to chance, so that no answer may depend on it. What a
/// call throws is thrown again here.
void shareOut(uint32_t count, uint32_t threads, const std::function<void(uint32_t)>& visit);

}  // namespace lampyris::reference
