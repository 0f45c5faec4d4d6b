#include "window/x11_errors.h"

#define GLFW_INCLUDE_NONE
#define GLFW_EXPOSE_NATIVE_X11
#include <GLFW/glfw3.h>
#include <GLFW/glfw3native.h>

#include <cstdlib>
#include <mutex>
#include <set>
#include <utility>

#include "core/log.h"

namespace lampyris::window {
namespace {

/// What errors say is gone. They come on any thread that speaks with the display.
class Gone {
 public:
    void add(XID id) {
        const std::scoped_lock lock(mutex_);
        ids_.insert(id);
    }
    void forget(XID id) {
        const std::scoped_lock lock(mutex_);
        ids_.erase(id);
    }
    [[nodiscard]] bool has(XID id) const {
        const std::scoped_lock lock(mutex_);
        return ids_.count(id) > 0;
    }

 private:
    mutable std::mutex mutex_;
    std::set<XID> ids_;
};

Gone& gone() {
    static Gone ids;
    return ids;
}

int onError(Display*, XErrorEvent* event) {
    if (event->error_code == BadWindow || event->error_code == BadDrawable)
        gone().add(event->resourceid);
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

void x11WindowIsNew(GLFWwindow* window) {
    gone().forget(glfwGetX11Window(window));
}

bool x11WindowWasDestroyed(GLFWwindow* window) {
    return gone().has(glfwGetX11Window(window));
}

}  // namespace lampyris::window
