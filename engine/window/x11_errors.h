/// \file X11's protocol errors, which by default end the program. Nothing happens without X11.
#pragma once

#include <functional>

struct GLFWwindow;

namespace lampyris::window {

/// Catches protocol errors from now on. GLFW puts the deadly handler back now and then, so this is
/// called at every poll.
void watchX11Errors();

/// From now on the program ends with 1 and one line where the connection to the display server
/// breaks, after `last` was called. Xlib cannot go on then, and would end it with words of its own.
void endWhereX11IsLost(std::function<void()> last);

/// Ids return: one that was another window's before is this one's now.
void x11WindowIsNew(GLFWwindow* window);

/// Whether an error said that this window is gone: somebody destroyed it under the program.
[[nodiscard]] bool x11WindowWasDestroyed(GLFWwindow* window);

}  // namespace lampyris::window
