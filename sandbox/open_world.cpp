#include "open_world.h"

#include "scene/load.h"
#include "scene/motion.h"

namespace lampyris::sandbox {

core::Result<ecs::World> openWorld(const Options& options) {
    TRY(ecs::World world, scene::loadScene(options.scene));
    scene::advanceTo(world, options.time, 0);
    return world;
}

}  // namespace lampyris::sandbox
