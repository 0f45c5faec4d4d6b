#include "scene/live_snapshot.h"

#include "scene/extract.h"
#include "scene/motion.h"
#include "scene/systems/world_transforms.h"

namespace lampyris::scene {

const SceneSnapshot& LiveSnapshot::follow(ecs::World& world, double seconds) {
    advanceTo(world, seconds, seen_);
    seconds_ = seconds;
    return take(world);
}

const SceneSnapshot& LiveSnapshot::followEdits(ecs::World& world) {
    if (!world.changedSince<AnimationPlayer>(seen_).empty() ||
        !world.changedSince<Patrol>(seen_).empty())
        return follow(world, seconds_);
    updateWorldTransforms(world, seen_);
    return take(world);
}

const SceneSnapshot& LiveSnapshot::take(ecs::World& world) {
    snapshot_ = extract(world, snapshot_, seen_);
    seen_ = world.advance();
    world.forgetRemovals(seen_);
    return snapshot_;
}

}  // namespace lampyris::scene
