/// \file A world's snapshot, kept up to date frame by frame: the clock, extract, and the ticks
/// between.
#pragma once

#include "ecs/world.h"
#include "scene/snapshot.h"

namespace lampyris::scene {

/// Remembers what it has seen of one world. Whoever has it drives that world's ticks: no other
/// reader of changes may be behind it.
class LiveSnapshot {
 public:
    /// Brings the world to a time (advanceTo), takes over what changed since the last call, and
    /// begins a new tick. The world is the same one at every call.
    const SceneSnapshot& follow(ecs::World& world, double seconds);
    /// The same while the world's time stands still: no system runs, so what was edited stays as it
    /// is, where a system would place it too; only where an AnimationPlayer or Patrol was edited
    /// do all systems run again.
    const SceneSnapshot& followEdits(ecs::World& world);
    /// As of the last follow(); empty before the first.
    [[nodiscard]] const SceneSnapshot& get() const { return snapshot_; }

 private:
    const SceneSnapshot& take(ecs::World& world);

    SceneSnapshot snapshot_;
    ecs::Tick seen_ = 0;
    double seconds_ = 0.0;  ///< the world's time, at the last follow()
};

}  // namespace lampyris::scene
