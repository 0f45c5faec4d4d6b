/// \file X11's protocol errors, which by default end the program. Nothing happens without X11.
#pragma once

namespace lampyris::window {

/// Catches protocol errors from now on. GLFW puts the deadly handler back now and then, so this is
/// called at every poll.
void watchX11Errors();

/// Whether an error said that the window or what is drawn into it is gone: somebody destroyed it
/// under the program.
[[nodiscard]] bool x11WindowWasDestroyed();

}  // namespace lampyris::window
