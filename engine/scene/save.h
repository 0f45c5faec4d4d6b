/// \file Whole scenes as JSON text: the entities, and where their meshes and materials came from.
#pragma once

#include <string>
#include <string_view>

#include "core/result.h"
#include "ecs/world.h"

namespace lampyris::scene {

/// { "format": "lampyris scene", "source": name or path, "world": … }. Meshes, materials and clips
/// are saved as their numbers in the source's Library, not by value: what was put under such a
/// number at run time is not saved, and an entity that shows or plays one added at run time is an
/// error. FrameTime and Motion are not saved: bring the loaded world to a time. The world must come
/// from loadScene or loadSavedScene.
core::Result<std::string> saveScene(const ecs::World& world);

/// The way back: loads the source again for its Library and fills a world with the saved entities.
/// Nothing is added where a camera or a light is missing. Errors name the entity and component.
core::Result<ecs::World> loadSavedScene(std::string_view text);

}  // namespace lampyris::scene
