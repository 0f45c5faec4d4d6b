/// \file The world's clock, and the systems that move what is in it.
#pragma once

#include "ecs/schedule.h"

namespace lampyris::scene {

/// A resource: what time it is. Systems place things by `seconds`, so that any step, none and a
/// backward one give what that time looks like.
struct FrameTime {
    double seconds = 0.0;
    double stepSeconds = 0.0;  ///< since the frame before; may be 0 or negative
};

/// A resource: the world's own systems, run in each frame after animations.
struct Motion {
    ecs::Schedule systems;
};

/// Brings a world to a time: sets FrameTime, plays its AnimationPlayers, runs its Motion, and
/// updates world transforms of what changed after `since`.
void advanceTo(ecs::World& world, double seconds, ecs::Tick since);

}  // namespace lampyris::scene
