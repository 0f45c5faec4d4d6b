/// \file The scene's components as JSON.
#pragma once

#include "ecs/registry.h"

namespace lampyris::scene {

/// Registers Name, Transform, MeshInstance, SphereLight and Camera under "name", "transform",
/// "mesh", "sphere_light" and "camera". WorldTransform is not saved: it follows from the rest.
/// Meshes and materials are numbers of the Library (see save.h). Loading refuses numbers that are
/// not finite, sizes and powers under 0 and fields of other kinds, and leaves defaults where a
/// field is missing.
void registerComponents(ecs::Registry& registry);

}  // namespace lampyris::scene
