/// \file References of what is measured: of the still picture, and of the moving sequence.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/dynamic_flicker.h"
#include "evaluation/picture.h"
#include "flicker/call.h"
#include "frame_loop.h"

namespace lampyris::sandbox::flicker {

/// The moving sequence as the reference has it, with the same random numbers in every frame.
struct MovingTruth {
    std::vector<core::DisplayImage> frames;
    evaluation::DynamicFlicker floor;  ///< between two seeds
};

/// Renders what it is asked for, once. Pictures are kept in the call's folder under what they show:
/// a small one of the same scene and moment is rendered first, and names the large one.
class Truths {
 public:
    /// Errors: the device or the scene is missing.
    static core::Result<Truths> open(const Call& call);

    /// At --time, all bounces, indirect light smoothed along surfaces; or the file that --reference
    /// names. Error: it is of another size.
    core::Result<const evaluation::Picture*> still();
    /// Null where nothing moves.
    core::Result<const MovingTruth*> moving();

 private:
    core::Result<core::Image> render(graph::Extent size, uint32_t samples, uint32_t seed);
    core::Result<core::Image> renderKept(graph::Extent size, uint32_t samples, uint32_t seed);
    [[nodiscard]] double secondsOf(uint32_t movingFrame) const;
    core::Result<bool> moves();
    core::Result<std::vector<core::DisplayImage>> sequence(uint32_t seed);

    const Call* call_ = nullptr;
    std::unique_ptr<FrameLoop> loop_;  ///< draws nothing: it has the frames' own snapshots
    std::optional<evaluation::Picture> still_;
    std::optional<MovingTruth> moving_;
    bool lookedForMotion_ = false;
};

}  // namespace lampyris::sandbox::flicker
