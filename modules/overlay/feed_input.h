/// \file What the user did, as Dear ImGui wants to hear it.
#pragma once

#include "window/window.h"

struct ImGuiIO;

namespace lampyris::overlay {

/// Once: which of the window's keys are ImGui's.
void mapKeys(ImGuiIO& io);

/// Once a frame. \param scaleX, scaleY  picture pixels a unit of the cursor's position
void feedInput(ImGuiIO& io, const window::Input& input, float scaleX, float scaleY);

}  // namespace lampyris::overlay
