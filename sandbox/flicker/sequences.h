/// \file The sequences of pictures that flicker is measured on.
#pragma once

#include <string>
#include <vector>

#include "core/display.h"
#include "frame_loop.h"

namespace lampyris::sandbox::flicker {

using Pictures = std::vector<core::DisplayImage>;

/// Pictures in which nothing moves, after the warm-up.
core::Result<Pictures> drawStill(FrameLoop& loop, const core::DisplayTransform& display,
                                 uint32_t warmup, uint32_t frames, uint64_t& frameNumber);

/// What a frame of an animation is drawn from, for the reference to draw it too.
struct MovingFrame {
    scene::SceneSnapshot snapshot;
    scene::SnapshotCamera camera;
};

struct Moving {
    Pictures pictures;
    std::vector<MovingFrame> frames;  ///< as many
    bool moves = false;               ///< anything changed from first to last
};

/// The animation from --time on, after the warm-up, in which it plays as well.
core::Result<Moving> drawMoving(FrameLoop& loop, const core::DisplayTransform& display,
                                uint32_t warmup, uint32_t frames);

enum class LightChange { Off, On, Moved };
[[nodiscard]] const char* nameOf(LightChange change);

/// Changes the strongest sphere light that systems leave alone, between still pictures: the last
/// before the change, and evaluation::kLastSettled after it. `On` undoes `Off`. Empty where the
/// scene has no such light.
core::Result<Pictures> drawChange(FrameLoop& loop, const core::DisplayTransform& display,
                                  LightChange change, uint64_t& frameNumber);

}  // namespace lampyris::sandbox::flicker
