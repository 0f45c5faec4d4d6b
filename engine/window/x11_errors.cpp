#include "window/x11_errors.h"

#include <X11/Xlib.h>

#include <atomic>

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

}  // namespace

void watchX11Errors() {
    XSetErrorHandler(onError);
}

bool x11WindowWasDestroyed() {
    return windowGone;
}

}  // namespace lampyris::window
