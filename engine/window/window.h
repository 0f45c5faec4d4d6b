/// \file A GLFW window and what the user does in it. The headless path never comes here. Who begins
/// GLFW ends it: a program that uses it itself calls glfwInit before it comes here, and
/// glfwTerminate when no Window is left.
#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "core/result.h"

struct GLFWwindow;

namespace lampyris::window {

struct WindowOptions {
    std::string title = "lampyris";
    uint32_t width = 1280;
    uint32_t height = 720;
};

/// Keys by GLFW's numbers, which are ASCII for letters and digits.
constexpr int kKeyEscape = 256;
constexpr int kKeyEnter = 257;
constexpr int kKeyTab = 258;
constexpr int kKeyBackspace = 259;
constexpr int kKeyInsert = 260;
constexpr int kKeyDelete = 261;
constexpr int kKeyRight = 262;
constexpr int kKeyLeft = 263;
constexpr int kKeyDown = 264;
constexpr int kKeyUp = 265;
constexpr int kKeyPageUp = 266;
constexpr int kKeyPageDown = 267;
constexpr int kKeyHome = 268;
constexpr int kKeyEnd = 269;
constexpr int kKeyF1 = 290;  ///< up to F12 in order
constexpr int kKeyKeypadEnter = 335;
constexpr int kKeyLeftShift = 340;
constexpr int kKeyLeftControl = 341;
constexpr int kKeyLeftAlt = 342;
constexpr int kKeyRightShift = 344;
constexpr int kKeyRightControl = 345;
constexpr int kKeyRightAlt = 346;
constexpr int kKeyCount = 349;

/// The state after the last poll(). Positions in window coordinates, from the top left. A poll
/// takes what happened up to the first mouse button that goes up or down, with the cursor where
/// that was, or to the first Shift, Control or Alt behind another key; the rest waits for the next,
/// so that no click is lost, lands elsewhere or is overtaken by a key, and keys mean what was held
/// with them, however long a frame takes.
struct Input {
    std::array<bool, kKeyCount> held{};
    std::array<bool, kKeyCount> pressed{};  ///< went down since the poll before
    std::array<bool, 3> buttons{};          ///< left, right, middle: held
    std::array<bool, 3> clicked{};          ///< went down since the poll before
    std::u32string typed;                   ///< characters, since the poll before
    double cursorX = 0.0, cursorY = 0.0;
    double movedX = 0.0, movedY = 0.0;  ///< of the cursor, since the poll before
    double scrolled = 0.0;              ///< lines, since the poll before

    [[nodiscard]] bool isHeld(int key) const { return held[static_cast<size_t>(key)]; }
    [[nodiscard]] bool wasPressed(int key) const { return pressed[static_cast<size_t>(key)]; }
    [[nodiscard]] bool shift() const { return isHeld(kKeyLeftShift) || isHeld(kKeyRightShift); }
    [[nodiscard]] bool control() const {
        return isHeld(kKeyLeftControl) || isHeld(kKeyRightControl);
    }
    [[nodiscard]] bool alt() const { return isHeld(kKeyLeftAlt) || isHeld(kKeyRightAlt); }
};

class Window {
 public:
    /// An Error says "no display" where there is none.
    static core::Result<Window> create(const WindowOptions& options);
    Window(Window&&) noexcept;
    Window& operator=(Window&& other) noexcept;
    ~Window();

    /// Takes in what happened. Call once a frame, on the thread that made the window.
    void poll();
    /// Sleeps until something happens, at most so long: for a minimised window. What was pressed
    /// meanwhile is in the next poll().
    void waitForEvents(double seconds);
    [[nodiscard]] const Input& input() const;

    /// The user pressed Escape or closed the window, or the window was destroyed from outside.
    [[nodiscard]] bool shouldClose() const;
    void requestClose();
    /// Whether Escape does: not while it ends something else, such as typing. At first it does.
    void setEscapeCloses(bool closes);
    /// Where the connection to the display breaks, the program ends with 1 and one line: nothing
    /// can go on from there. `last` is called before, to write what must not be lost.
    void whenDisplayIsLost(std::function<void()> last);
    /// In the units of the cursor's position; 0 by 0 where it was destroyed.
    [[nodiscard]] VkExtent2D size() const;
    /// In pixels; 0 by 0 while minimised, and where it was destroyed.
    [[nodiscard]] VkExtent2D framebufferSize() const;
    void resize(uint32_t width, uint32_t height);
    void setTitle(const std::string& title);
    /// Over the whole of the monitor that most of it lies on, or back to where it was.
    void setFullScreen(bool on);
    [[nodiscard]] bool fullScreen() const;

    void setClipboard(const std::string& text);
    [[nodiscard]] std::string clipboard() const;

    /// A Vulkan surface for it; the caller destroys it, before the window.
    core::Result<VkSurfaceKHR> createSurface(VkInstance instance) const;
    /// For the overlay's GLFW backend.
    [[nodiscard]] GLFWwindow* handle() const;

 private:
    void takeEvents();

    struct State;
    explicit Window(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace lampyris::window
