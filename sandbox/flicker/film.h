/// \file Frames one after the other, as a screen shows them.
#pragma once

#include <memory>

#include "core/display.h"
#include "frame_loop.h"

namespace lampyris::sandbox::flicker {

class Film {
 public:
    /// Warns of nothing: another loop read the scene before.
    static core::Result<Film> open(const Options& options);

    /// Draws frames that nobody looks at.
    core::Result<void> skip(uint32_t frames);
    core::Result<core::DisplayImage> next();

    [[nodiscard]] FrameLoop& loop() { return *loop_; }

 private:
    std::unique_ptr<FrameLoop> loop_;
    core::DisplayTransform display_;
    uint64_t number_ = 0;
};

}  // namespace lampyris::sandbox::flicker
