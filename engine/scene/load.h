/// \file A scene by name or path, ready to be drawn.
#pragma once

#include <cstddef>
#include <string>

#include "core/result.h"
#include "ecs/world.h"

namespace lampyris::scene {

/// Where a world's Library came from; a resource of every loaded world, so that a saved world can
/// be loaded again.
struct SceneSource {
    std::string nameOrPath;
    size_t meshCount = 0;      ///< of the Library as loaded
    size_t materialCount = 0;  ///< of the Library as loaded
    size_t clipCount = 0;      ///< of the Library as loaded
};

/// Whether it names a file, by its ending: .gltf or .glb.
[[nodiscard]] bool namesFile(const std::string& nameOrPath);

/// A built-in name, or a path that ends in .gltf or .glb. The world has a Library, a camera, a
/// light or something emissive, something to draw, world transforms, and is at time 0. What had to
/// be added or left out is a warning line. Errors name the scene: unknown name, broken file, no
/// mesh to draw.
core::Result<ecs::World> loadScene(const std::string& nameOrPath);

/// The same as the file has it: nothing added for a missing camera or light.
core::Result<ecs::World> readScene(const std::string& nameOrPath);

}  // namespace lampyris::scene
