/// \file A camera that walks: W A S D over the ground and falling to it, hovering where there is
/// none, held up by walls; the left mouse button turns it.
#pragma once

#include "scene/snapshot.h"
#include "window/window.h"

namespace lampyris::sandbox::view {

class WalkCamera {
 public:
    static constexpr float kEyeMetres = 1.7f;

    /// Where the camera is after `seconds` of this input.
    [[nodiscard]] glm::mat4 walk(const glm::mat4& cameraToWorld, const window::Input& input,
                                 const scene::SceneSnapshot& snapshot, float seconds);

 private:
    float fallMetresPerSecond_ = 0.0f;
};

}  // namespace lampyris::sandbox::view
