/// \file The only door out of the ECS.
#pragma once

#include "ecs/world.h"
#include "scene/snapshot.h"

namespace lampyris::scene {

/// What renderers may know of the world, made from the previous snapshot by looking only at what
/// changed after `since`; what did not change is shared and keeps its versions. The first call
/// takes an empty snapshot and since = 0; `previous` is otherwise the snapshot of this world as of
/// `since`. World transforms must be up to date.
///   reads  MeshInstance, SphereLight, Camera (each drawn where it has a WorldTransform), Skin,
///          MorphWeights, Transform and hierarchy of joints, Name, Library
/// Instances without a mesh are left out; those without a material get kDefaultMaterial.
SceneSnapshot extract(const ecs::World& world, const SceneSnapshot& previous, ecs::Tick since);

}  // namespace lampyris::scene
