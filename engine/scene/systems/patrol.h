/// \file Moves what patrols.
#pragma once

#include "ecs/system.h"
#include "scene/components.h"
#include "scene/motion.h"

namespace lampyris::scene {

/// Sets the translation to where the patrol is at the frame's time, whatever the frames before
/// were; no change is marked where it stands still. Without waypoints nothing is set; where they
/// have no length, or the time no place on it, it is the first one.
void patrol(ecs::Write<Transform> transform, ecs::Read<Patrol> patrol, const FrameTime& time);

}  // namespace lampyris::scene
