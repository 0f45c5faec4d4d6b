#include "scene/live_snapshot.h"

#include "scene/extract.h"
#include "scene/motion.h"
#include "scene/systems/world_transforms.h"

namespace lampyris::scene {

const SceneSnapshot& LiveSnapshot::follow(ecs::World& world, double seconds) {
    advanceTo(world, seconds, seen_);
    return take(world);
}

const SceneSnapshot& LiveSnapshot::followEdits(ecs::World& world) {
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
