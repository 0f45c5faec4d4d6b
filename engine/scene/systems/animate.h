/// \file Plays animation clips.
#pragma once

#include "ecs/world.h"

namespace lampyris::scene {

/// Sets what every AnimationPlayer drives to its value at the world's FrameTime [glTF 2.0, 3.11,
/// appendix C]. A value that comes out as it was is not marked as changed; a target that is gone is
/// passed over.
///   reads   FrameTime, Library, AnimationPlayer      writes  Transform, MorphWeights
void animate(ecs::World& world);

}  // namespace lampyris::scene
