/// \file Keeps WorldTransform in step with Transform and the hierarchy.
#pragma once

#include <cstdint>

#include "ecs/world.h"

namespace lampyris::scene {

/// Recomputes the WorldTransform of every entity whose Transform or parent changed after `since`,
/// and of all below it; touches no other. An entity without a Transform has no WorldTransform and
/// hands its parent's on. A WorldTransform that comes out as it was is not marked as changed.
///   reads   Transform, Parent, Children      writes  WorldTransform
/// Returns how many were recomputed.
uint32_t updateWorldTransforms(ecs::World& world, ecs::Tick since = 0);

}  // namespace lampyris::scene
