/// \file overlay/look: any image of the frame as something to look at.
///   in      an image by its resource's name      out   an RGBA8 picture of it, and findings: a
///   histogram, the range, the value under the cursor; of the frame before the last
///   shader  overlay/look.comp
#pragma once

#include <array>
#include <optional>
#include <string>

#include "gpu/buffer.h"
#include "graph/frame.h"
#include "shared/overlay.h"

namespace lampyris::overlay {

/// What is looked at, and how.
struct LookChoice {
    std::string name;  ///< of the resource; empty: nothing
    uint32_t channel = shared::LOOK_COLOUR;
    uint32_t layer = 0;
    float exposureEv = 0.0f;
    bool wholeRange = false;  ///< black is the least value, white the most, instead of 0 and 1
    bool encode = true;       ///< as linear light
    std::optional<glm::uvec2> cursor;  ///< texel under it
};

class ImageLook {
 public:
    static core::Result<ImageLook> create(gpu::Device& device);

    LookChoice choice;

    /// Call once all of the frame's nodes are declared: the image's last contents are seen. Invalid
    /// where nothing is chosen, or the frame has no such image.
    [[nodiscard]] graph::Image addNode(graph::Frame& frame);

    /// Of two frames ago; nothing before there were any.
    [[nodiscard]] const shared::LookFindings* findings() const;
    /// The texel under the cursor that findings() are of.
    [[nodiscard]] const std::optional<glm::uvec2>& cursor() const { return cursors_[next_]; }
    [[nodiscard]] const graph::ImageDesc& desc() const { return desc_; }  ///< of what is looked at
    /// The last frame had no image of that name.
    [[nodiscard]] bool isMissing() const { return missing_ && choice.name == shownName_; }
    /// The least and the most finite value of the channels that are shown and that the image has.
    [[nodiscard]] std::array<float, 2> range() const;

 private:
    explicit ImageLook(std::array<gpu::Buffer, 2> buffers) : buffers_(std::move(buffers)) {}
    std::array<gpu::Buffer, 2> buffers_;  ///< in turn; the device writes one, the host reads one
    std::array<bool, 2> written_{};
    std::array<std::optional<glm::uvec2>, 2> cursors_;
    size_t next_ = 0;
    std::string shownName_;
    bool missing_ = false;
    graph::ImageDesc desc_;
};

}  // namespace lampyris::overlay
