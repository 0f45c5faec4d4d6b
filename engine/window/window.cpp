#include "window/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <deque>
#include <optional>
#include <utility>

#include "gpu/vulkan_result.h"
#include "window/monitors.h"
#include "window/x11_errors.h"

namespace lampyris::window {
namespace {

int openWindows = 0;     // GLFW's end is the end of them all; it is used from one thread alone
bool begunByUs = false;  // and so ended by us

bool isBegun() {
    const GLFWerrorfun told = glfwSetErrorCallback(nullptr);
    glfwGetError(nullptr);
    (void)glfwGetTime();
    const bool begun = glfwGetError(nullptr) != GLFW_NOT_INITIALIZED;
    glfwSetErrorCallback(told);
    return begun;
}

bool begin() {
    const bool begun = isBegun();
    if (glfwInit() != GLFW_TRUE) return false;
    begunByUs = begunByUs || !begun;
    return true;
}

void terminateUnused() {
    if (openWindows == 0 && std::exchange(begunByUs, false)) glfwTerminate();
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

/// What GLFW 3.3 says of a window that was destroyed is memory that nobody wrote.
VkExtent2D sizeOrNone(GLFWwindow* window, int width, int height) {
    if (x11WindowWasDestroyed(window) || width < 0 || height < 0) return {0, 0};
    return {static_cast<uint32_t>(width), static_cast<uint32_t>(height)};
}

bool isModifier(size_t key) {
    constexpr std::array kModifiers{kKeyLeftShift,  kKeyLeftControl,  kKeyLeftAlt,
                                    kKeyRightShift, kKeyRightControl, kKeyRightAlt};
    return std::find(kModifiers.begin(), kModifiers.end(), static_cast<int>(key)) !=
           kModifiers.end();
}

}  // namespace

/// One thing that the user did, and where the cursor was. At most one of the three.
struct Event {
    double x = 0.0, y = 0.0;
    std::optional<size_t> button{}, key{};
    int action = GLFW_RELEASE;  ///< of the button or key
    char32_t typed = 0;
};

/// GLFW's callbacks write here; its address stays when the Window moves.
struct Window::State {
    GLFWwindow* window = nullptr;
    Input input;
    std::deque<Event> events;  ///< in order, not yet in `input`
    double scrolled = 0.0;     ///< likewise
    bool closeRequested = false;
    bool escapeCloses = true;
    std::optional<Place> beforeFullScreen;

    /// One where the cursor was last.
    Event& add() {
        const Event last = events.empty() ? Event{input.cursorX, input.cursorY} : events.back();
        return events.emplace_back(Event{last.x, last.y});
    }
};

core::Result<std::vector<MonitorInfo>> listMonitors() {
    if (!begin()) return core::error("no display ({})", glfwMessage());
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
    if (!begin()) return core::error("no display ({})", glfwMessage());
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
        Event& event = static_cast<State*>(glfwGetWindowUserPointer(from))->add();
        event.key = static_cast<size_t>(key);
        event.action = action;
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* from, int button, int action, int) {
        auto& state = *static_cast<State*>(glfwGetWindowUserPointer(from));
        const auto index = static_cast<size_t>(button);
        if (index >= state.input.buttons.size()) return;
        Event& event = state.add();
        event.button = index;
        event.action = action;
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow* from, double x, double y) {
        static_cast<State*>(glfwGetWindowUserPointer(from))->events.push_back(Event{x, y});
    });
    glfwSetCharCallback(window, [](GLFWwindow* from, unsigned character) {
        static_cast<State*>(glfwGetWindowUserPointer(from))->add().typed = char32_t{character};
    });
    glfwSetScrollCallback(window, [](GLFWwindow* from, double, double lines) {
        static_cast<State*>(glfwGetWindowUserPointer(from))->scrolled += lines;
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
    watchX11Errors();
    glfwPollEvents();
    input.pressed.fill(false);
    input.clicked.fill(false);
    input.typed.clear();
    input.scrolled = std::exchange(state_->scrolled, 0.0);
    const double oldX = input.cursorX;
    const double oldY = input.cursorY;
    takeEvents();
    input.movedX = input.cursorX - oldX;
    input.movedY = input.cursorY - oldY;
}

void Window::takeEvents() {
    Input& input = state_->input;
    bool pressed = false;  // a key that modifiers change the meaning of
    while (!state_->events.empty()) {
        const Event event = state_->events.front();
        if (event.key && isModifier(*event.key) && pressed) return;
        state_->events.pop_front();
        input.cursorX = event.x;
        input.cursorY = event.y;
        if (event.typed != 0) input.typed += event.typed;
        if (event.key) {
            input.held[*event.key] = event.action != GLFW_RELEASE;
            if (event.action == GLFW_PRESS) input.pressed[*event.key] = true;
            pressed = pressed || (event.action == GLFW_PRESS && !isModifier(*event.key));
            if (event.action == GLFW_PRESS && *event.key == kKeyEscape && state_->escapeCloses)
                state_->closeRequested = true;
        }
        if (!event.button) continue;
        input.buttons[*event.button] = event.action == GLFW_PRESS;
        input.clicked[*event.button] = event.action == GLFW_PRESS;
        return;  // what comes after happened elsewhere
    }
    glfwGetCursorPos(state_->window, &input.cursorX, &input.cursorY);  // outside too
}

void Window::waitForEvents(double seconds) {
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
    return sizeOrNone(state_->window, width, height);
}

VkExtent2D Window::framebufferSize() const {
    int width = 0;
    int height = 0;
    if (glfwGetWindowAttrib(state_->window, GLFW_ICONIFIED) == GLFW_FALSE)
        glfwGetFramebufferSize(state_->window, &width, &height);
    return sizeOrNone(state_->window, width, height);
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
