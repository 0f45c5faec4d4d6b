/// \file A camera that flies: W A S D, Q and E down and up, the left mouse button turns it.
#pragma once

#include "math/glm.h"
#include "window/window.h"

namespace lampyris::sandbox {

/// Where the camera is after `seconds` of this input.
[[nodiscard]] glm::mat4 fly(const glm::mat4& cameraToWorld, const window::Input& input,
                            float metresPerSecond, float seconds);

}  // namespace lampyris::sandbox
