#include "scene/motion.h"

#include "scene/systems/animate.h"
#include "scene/systems/world_transforms.h"

namespace lampyris::scene {

void advanceTo(ecs::World& world, double seconds, ecs::Tick since) {
    const auto* before = world.findResource<FrameTime>();
    world.setResource(FrameTime{seconds, before == nullptr ? 0.0 : seconds - before->seconds});
    animate(world);
    if (const auto* motion = world.findResource<Motion>()) motion->systems.run(world);
    updateWorldTransforms(world, since);
}

}  // namespace lampyris::scene
