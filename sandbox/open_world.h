/// \file A scene as the program's calls name it.
#pragma once

#include "ecs/world.h"
#include "options.h"

namespace lampyris::sandbox {

/// The courtyard, or any scene that scene::loadScene knows, with its animation chosen, and placed
/// at --time. Errors name the scene or animation that is missing.
core::Result<ecs::World> openWorld(const Options& options);

}  // namespace lampyris::sandbox
