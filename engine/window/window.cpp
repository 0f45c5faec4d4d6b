#include "window/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <deque>
#include <optional>
#include <utility>

#include "gpu/vulkan_result.h"
#include "window/monitors.h"
#include "window/x11_errors.h"

namespace lampyris::window {
namespace {

int openWindows = 0;  // GLFW's end is the end of them all; it is used from one thread alone

void terminateUnused() {
    if (openWindows == 0) glfwTerminate();
}

std::string glfwMessage() {
    const char* description = nullptr;
    glfwGetError(&description);
    return description == nullptr ? "no reason given" : description;
}

/// In screen coordinates.
struct Place {
    int x = 0, y = 0, width = 0, height = 0;
};

/// The one that the middle of a window of that place lies on; the first where it lies on none.
GLFWmonitor* monitorUnder(const Place& place) {
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    const int x = place.x + place.width / 2;
    const int y = place.y + place.height / 2;
    for (int i = 0; i < count; ++i) {
        const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
        Place at;
        glfwGetMonitorPos(monitors[i], &at.x, &at.y);
        if (mode != nullptr && x >= at.x && x < at.x + mode->width && y >= at.y &&
            y < at.y + mode->height)
            return monitors[i];
    }
    return count > 0 ? monitors[0] : nullptr;
}

}  // namespace

/// What the mouse did, in order: it went somewhere, and there a button may have gone up or down.
struct MouseEvent {
    double x = 0.0, y = 0.0;
    std::optional<size_t> button{};
    bool down = false;
};

/// GLFW's callbacks write here; its address stays when the Window moves.
struct Window::State {
    GLFWwindow* window = nullptr;
    Input input;
    std::deque<MouseEvent> mouse;  ///< not yet in `input`
    bool closeRequested = false;
    bool escapeCloses = true;
    bool inputSeen = false;  ///< what the last poll found may be forgotten
    std::optional<Place> beforeFullScreen;
};

core::Result<std::vector<MonitorInfo>> listMonitors() {
    if (glfwInit() != GLFW_TRUE) return core::error("no display ({})", glfwMessage());
    std::vector<MonitorInfo> monitors;
    int count = 0;
    GLFWmonitor** const found = glfwGetMonitors(&count);
    for (int i = 0; i < count; ++i) {
        const GLFWvidmode* const mode = glfwGetVideoMode(found[i]);
        if (mode == nullptr) continue;
        const char* const name = glfwGetMonitorName(found[i]);
        monitors.push_back({name == nullptr ? "" : name, static_cast<uint32_t>(mode->width),
                            static_cast<uint32_t>(mode->height),
                            static_cast<uint32_t>(std::max(mode->refreshRate, 0))});
    }
    terminateUnused();
    return monitors;
}

core::Result<Window> Window::create(const WindowOptions& options) {
    if (glfwInit() != GLFW_TRUE) return core::error("no display ({})", glfwMessage());
    auto state = std::make_unique<State>();
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    state->window =
        glfwCreateWindow(static_cast<int>(options.width), static_cast<int>(options.height),
                         options.title.c_str(), nullptr, nullptr);
    if (state->window == nullptr) {
        const std::string why = glfwMessage();
        terminateUnused();
        return core::error("cannot open a window: {}", why);
    }
    return Window{std::move(state)};
}

Window::Window(std::unique_ptr<State> state) : state_(std::move(state)) {
    ++openWindows;
    GLFWwindow* window = state_->window;
    glfwSetWindowUserPointer(window, state_.get());
    glfwSetKeyCallback(window, [](GLFWwindow* from, int key, int, int action, int) {
        if (key < 0 || key >= kKeyCount) return;
        auto& state = *static_cast<State*>(glfwGetWindowUserPointer(from));
        state.input.held[static_cast<size_t>(key)] = action != GLFW_RELEASE;
        if (action == GLFW_PRESS) state.input.pressed[static_cast<size_t>(key)] = true;
        if (key == kKeyEscape && action == GLFW_PRESS && state.escapeCloses)
            state.closeRequested = true;
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* from, int button, int action, int) {
        auto& state = *static_cast<State*>(glfwGetWindowUserPointer(from));
        const auto index = static_cast<size_t>(button);
        if (index >= state.input.buttons.size()) return;
        MouseEvent event = state.mouse.empty()
                               ? MouseEvent{state.input.cursorX, state.input.cursorY}
                               : state.mouse.back();
        event.button = index;
        event.down = action == GLFW_PRESS;
        state.mouse.push_back(event);
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow* from, double x, double y) {
        static_cast<State*>(glfwGetWindowUserPointer(from))->mouse.push_back({x, y});
    });
    glfwSetCharCallback(window, [](GLFWwindow* from, unsigned character) {
        static_cast<State*>(glfwGetWindowUserPointer(from))->input.typed += char32_t{character};
    });
    glfwSetScrollCallback(window, [](GLFWwindow* from, double, double lines) {
        static_cast<State*>(glfwGetWindowUserPointer(from))->input.scrolled += lines;
    });
    glfwGetCursorPos(window, &state_->input.cursorX, &state_->input.cursorY);
    x11WindowIsNew(window);
    watchX11Errors();
    endWhereX11IsLost({});
}

Window::Window(Window&&) noexcept = default;

Window& Window::operator=(Window&& other) noexcept {
    std::swap(state_, other.state_);
    return *this;
}

Window::~Window() {
    if (state_ == nullptr) return;
    watchX11Errors();
    glfwDestroyWindow(state_->window);
    --openWindows;
    terminateUnused();
}

void Window::poll() {
    Input& input = state_->input;
    forgetSeenInput();
    watchX11Errors();
    glfwPollEvents();
    state_->inputSeen = true;
    const double oldX = input.cursorX;
    const double oldY = input.cursorY;
    takeMouse();
    input.movedX = input.cursorX - oldX;
    input.movedY = input.cursorY - oldY;
}

void Window::takeMouse() {
    Input& input = state_->input;
    while (!state_->mouse.empty()) {
        const MouseEvent event = state_->mouse.front();
        state_->mouse.pop_front();
        input.cursorX = event.x;
        input.cursorY = event.y;
        if (!event.button) continue;
        input.buttons[*event.button] = event.down;
        input.clicked[*event.button] = event.down;
        return;  // what comes after happened elsewhere
    }
    glfwGetCursorPos(state_->window, &input.cursorX, &input.cursorY);  // outside too
}

void Window::forgetSeenInput() {
    if (!std::exchange(state_->inputSeen, false)) return;
    Input& input = state_->input;
    input.pressed.fill(false);
    input.clicked.fill(false);
    input.typed.clear();
    input.scrolled = 0.0;
}

void Window::waitForEvents(double seconds) {
    forgetSeenInput();
    glfwWaitEventsTimeout(seconds);
}

const Input& Window::input() const {
    return state_->input;
}

bool Window::shouldClose() const {
    return state_->closeRequested || x11WindowWasDestroyed(state_->window) ||
           glfwWindowShouldClose(state_->window) == GLFW_TRUE;
}

void Window::whenDisplayIsLost(std::function<void()> last) {
    endWhereX11IsLost(std::move(last));
}

void Window::setEscapeCloses(bool closes) {
    state_->escapeCloses = closes;
}

void Window::requestClose() {
    state_->closeRequested = true;
}

VkExtent2D Window::size() const {
    int width = 0;
    int height = 0;
    glfwGetWindowSize(state_->window, &width, &height);
    return {static_cast<uint32_t>(width), static_cast<uint32_t>(height)};
}

VkExtent2D Window::framebufferSize() const {
    int width = 0;
    int height = 0;
    if (glfwGetWindowAttrib(state_->window, GLFW_ICONIFIED) == GLFW_FALSE)
        glfwGetFramebufferSize(state_->window, &width, &height);
    return {static_cast<uint32_t>(width), static_cast<uint32_t>(height)};
}

void Window::resize(uint32_t width, uint32_t height) {
    glfwSetWindowSize(state_->window, static_cast<int>(width), static_cast<int>(height));
}

void Window::setTitle(const std::string& title) {
    glfwSetWindowTitle(state_->window, title.c_str());
}

void Window::setFullScreen(bool on) {
    if (on == fullScreen()) return;
    if (!on) {
        const Place place = *std::exchange(state_->beforeFullScreen, std::nullopt);
        glfwSetWindowMonitor(state_->window, nullptr, place.x, place.y, place.width, place.height,
                             GLFW_DONT_CARE);
        return;
    }
    Place place;
    glfwGetWindowPos(state_->window, &place.x, &place.y);
    glfwGetWindowSize(state_->window, &place.width, &place.height);
    GLFWmonitor* const monitor = monitorUnder(place);
    const GLFWvidmode* const mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
    if (mode == nullptr) return;  // no monitor is left
    state_->beforeFullScreen = place;
    glfwSetWindowMonitor(state_->window, monitor, 0, 0, mode->width, mode->height,
                         mode->refreshRate);
}

bool Window::fullScreen() const {
    return state_->beforeFullScreen.has_value();
}

void Window::setClipboard(const std::string& text) {
    glfwSetClipboardString(state_->window, text.c_str());
}

std::string Window::clipboard() const {
    const char* text = glfwGetClipboardString(state_->window);
    return text == nullptr ? std::string{} : text;
}

core::Result<VkSurfaceKHR> Window::createSurface(VkInstance instance) const {
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    VK_TRY(glfwCreateWindowSurface(instance, state_->window, nullptr, &surface));
    return surface;
}

GLFWwindow* Window::handle() const {
    return state_->window;
}

}  // namespace lampyris::window
