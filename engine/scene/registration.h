/// \file The scene's components as JSON.
#pragma once

#include "ecs/registry.h"

namespace lampyris::scene {

/// Registers Name, Transform, MeshInstance, MeshPart, SphereLight, Camera, MorphWeights, Patrol,
/// Skin and AnimationPlayer under "name", "transform", "mesh", "mesh_part", "sphere_light",
/// "camera", "morph_weights", "patrol", "skin" and "animation_player". WorldTransform is not saved:
/// it follows from the rest. Meshes, materials and clips are numbers of the Library (see save.h).
/// Loading refuses numbers that are not finite, sizes and powers under 0 and fields of other kinds,
/// and leaves defaults where a field is missing.
void registerComponents(ecs::Registry& registry);

}  // namespace lampyris::scene
