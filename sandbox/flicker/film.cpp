#include "flicker/film.h"

#include "core/log.h"

namespace lampyris::sandbox::flicker {

core::Result<Film> Film::open(const Options& options) {
    Film film;
    // What the scene's file warns of was said when the first loop read it.
    core::holdLog();
    auto loop = FrameLoop::open(options);
    (void)core::takeHeldLog();
    TRY(film.loop_, std::move(loop));
    film.display_ = options.display;
    return film;
}

core::Result<void> Film::skip(uint32_t frames) {
    for (uint32_t i = 0; i < frames; ++i) {
        TRY(const LoopFrame frame, loop_->draw(number_++));
    }
    return {};
}

core::Result<core::DisplayImage> Film::next() {
    TRY(const LoopFrame frame, loop_->draw(number_++, true));
    return core::toDisplay(frame.outcome.image, display_);
}

}  // namespace lampyris::sandbox::flicker
