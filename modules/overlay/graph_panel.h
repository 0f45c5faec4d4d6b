/// \file Graph: nodes, images and buffers of the last frame, their lifetimes, barriers and memory;
/// what was culled, and why.
#pragma once

#include <string>

#include "overlay/frame_seen.h"
#include "overlay/image_look.h"

namespace lampyris::overlay {

class GraphPanel {
 public:
    /// \param choice  set to the image that is clicked on
    void draw(const FrameSeen& seen, LookChoice& choice, bool* open);

 private:
    int node_ = -1;  ///< the step that is looked into
};

}  // namespace lampyris::overlay
