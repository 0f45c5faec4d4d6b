/// \file Images that the next frame may show again, where nothing that they show can have changed.
#pragma once

#include <string>

#include "graph/frame.h"

namespace lampyris::deferred {

/// What becomes of the images that a node draws.
enum class Keep : bool {
    No,   ///< they are this frame's alone
    Yes,  ///< they go on to the next frame, which may take them with kept()
};

/// An image to be drawn.
[[nodiscard]] inline graph::Image keepable(graph::Frame& frame, Keep keep, const std::string& name,
                                           const graph::ImageDesc& desc) {
    return keep == Keep::Yes ? frame.history("kept " + name, desc, false).current
                             : frame.image(name, desc);
}

/// As the last frame that kept it drew it.
[[nodiscard]] inline graph::Image kept(graph::Frame& frame, const std::string& name,
                                       const graph::ImageDesc& desc) {
    return frame.history("kept " + name, desc, true).previous;
}

}  // namespace lampyris::deferred
