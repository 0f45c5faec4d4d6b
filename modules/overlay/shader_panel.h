/// \file Shaders: those that were reloaded while the program runs, and those that are broken.
#pragma once

#include <span>

#include "shader_reload/shader_reloader.h"

namespace lampyris::overlay {

/// \param shaders  all that are followed; empty where none are
void drawShaderPanel(std::span<const shader_reload::ShaderStatus> shaders, bool* open);

/// How many of them are broken, in words, for the menu bar; empty where none is.
[[nodiscard]] std::string brokenShaders(std::span<const shader_reload::ShaderStatus> shaders);

}  // namespace lampyris::overlay
