#include "flicker/film.h"

namespace lampyris::sandbox::flicker {

core::Result<Film> Film::open(const Options& options) {
    Film film;
    TRY(film.loop_, FrameLoop::open(options));
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
