#include "window/x11_errors.h"

#include <X11/Xlib.h>

#include <atomic>
#include <cstdlib>
#include <utility>

#include "core/log.h"

namespace lampyris::window {
namespace {

std::atomic<bool> windowGone{false};

int onError(Display*, XErrorEvent* event) {
    if (event->error_code == BadWindow || event->error_code == BadDrawable) windowGone = true;
    core::logDebug("X11 error {} at request {}", static_cast<int>(event->error_code),
                   static_cast<int>(event->request_code));
    return 0;
}

/// Called once, on the thread that speaks with the display.
std::function<void()>& lastWords() {
    static std::function<void()> words;
    return words;
}

int onBrokenConnection(Display* /*display*/) {
    if (const auto words = std::exchange(lastWords(), {})) words();
    core::releaseLog();
    core::logError("the display is lost");
    std::_Exit(1);  // what destructors would say to the display, nobody hears
}

}  // namespace

void endWhereX11IsLost(std::function<void()> last) {
    lastWords() = std::move(last);
    XSetIOErrorHandler(onBrokenConnection);
}

void watchX11Errors() {
    XSetErrorHandler(onError);
}

bool x11WindowWasDestroyed() {
    return windowGone;
}

}  // namespace lampyris::window
