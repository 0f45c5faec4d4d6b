/// \file The monitors of the display, for those who ask before they open a window. GLFW is ended
/// again where it was not begun before (window.h).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/result.h"

namespace lampyris::window {

struct MonitorInfo {
    std::string name;
    uint32_t width = 0, height = 0;  ///< pixels
    uint32_t hertz = 0;              ///< 0: not known
};

/// The first is the main one. An Error says "no display" where there is none.
core::Result<std::vector<MonitorInfo>> listMonitors();

}  // namespace lampyris::window
