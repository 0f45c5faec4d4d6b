/// \file The arrow keys move the scene's player, if it has one, as the camera sees it.
#pragma once

#include "ecs/world.h"
#include "math/glm.h"
#include "window/window.h"

namespace lampyris::sandbox {

/// Up is away from the camera. Moves nobody while no arrow is held.
void steerPlayer(ecs::World& world, const glm::mat4& cameraToWorld, const window::Input& input,
                 float seconds);

}  // namespace lampyris::sandbox
