/// \file What one frame of `view` is given from outside: all that a replay must repeat.
#pragma once

#include "graph/resource.h"
#include "window/window.h"

namespace lampyris::sandbox::view {

struct Moment {
    window::Input input;
    float seconds = 0.0f;        ///< since the frame before, of the wall clock
    graph::Extent windowSize{};  ///< in the units of the cursor's position
    graph::Extent size{};        ///< of the picture, pixels
};

}  // namespace lampyris::sandbox::view
