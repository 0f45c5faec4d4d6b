/// \file Graph: nodes, images and buffers of the last frame, their lifetimes, barriers and memory;
/// what was culled, and why.
#pragma once

#include <optional>
#include <string>

#include "overlay/frame_seen.h"
#include "overlay/image_look.h"

namespace lampyris::overlay {

/// A node as it is known from frame to frame: its step may be another one in each.
struct NodeName {
    std::string name;
    int occurrence = 0;  ///< among those of that name
    bool operator==(const NodeName&) const = default;
};

class GraphPanel {
 public:
    /// \param choice  set to the image that is clicked on
    void draw(const FrameSeen& seen, LookChoice& choice, bool* open);
    /// The node that is looked into.
    [[nodiscard]] const std::optional<NodeName>& opened() const { return opened_; }

 private:
    std::optional<NodeName> opened_;
};

}  // namespace lampyris::overlay
