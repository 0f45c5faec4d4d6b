/// \file Flicker and lag of a running program: frames are looked at two frames after they were
/// shown.
#pragma once

#include <deque>
#include <filesystem>
#include <optional>
#include <string>

#include "evaluation/flicker.h"
#include "evaluation/lag.h"
#include "execute/copy_ring.h"
#include "frame_loop.h"

namespace lampyris::sandbox::flicker {

/// What a frame shows; nothing moves while it stays the same.
struct Shown {
    uint64_t sceneVersion = 0;  ///< of lights, geometry and materials
    glm::mat4 cameraToWorld{1.0f};
    graph::Extent size;
    bool operator==(const Shown&) const = default;
};

/// Keeps figures of the frames since the last change.
class Watched {
 public:
    core::Result<void> add(const Shown& shown, const core::DisplayImage& image);

    /// "frame,since_change,change": frames since anything changed, and [F3] in luma of 255.
    [[nodiscard]] const std::string& csv() const { return csv_; }
    /// One line: static flicker of the last frames that were still, and the last lag.
    [[nodiscard]] std::string summary() const;

 private:
    core::Result<void> startOver(const Shown& shown);

    std::optional<Shown> last_;
    core::DisplayImage lastImage_;
    uint64_t frame_ = 0, sinceChange_ = 0;
    evaluation::FlickerMeter all_;    ///< of this size: for changes from frame to frame
    evaluation::FlickerMeter still_;  ///< past the warm-up after a change
    std::optional<evaluation::StaticFlicker> flicker_;  ///< of the last still frames, if they ended
    size_t stillFrames_ = 0;                            ///< behind flicker_
    std::optional<evaluation::LagMeter> following_;     ///< a change of the scene
    std::optional<evaluation::Lag> lag_;
    std::string csv_ = "frame,since_change,change\n";
};

/// Copies what is shown, and hands it to Watched.
class Watch {
 public:
    static core::Result<Watch> create(gpu::Device& device);

    /// After a frame was drawn whole; `image` is what it shows, of that description.
    core::Result<void> follow(FrameLoop& loop, const gpu::Image& image,
                              const graph::ImageDesc& desc);
    /// Looks at the last frames too, and writes the figures.
    core::Result<void> finish(const std::filesystem::path& csv);
    [[nodiscard]] std::string summary() const { return watched_.summary(); }

 private:
    explicit Watch(execute::CopyRing ring) : ring_(std::move(ring)) {}
    core::Result<void> take(const execute::RawImage& copy);

    execute::CopyRing ring_;
    std::deque<Shown> shown_;  ///< of the copies in the ring, oldest first
    Watched watched_;
};

}  // namespace lampyris::sandbox::flicker
