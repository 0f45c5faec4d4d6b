#include "open_world.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "courtyard/courtyard.h"
#include "scene/builtin/builtin.h"
#include "scene/load.h"
#include "scene/motion.h"

namespace lampyris::sandbox {
namespace {

core::Result<ecs::World> load(const std::string& name) {
    if (name == courtyard::kSceneName) return courtyard::makeCourtyard();
    const auto builtin = scene::builtinSceneNames();
    const bool known = std::find(builtin.begin(), builtin.end(), name) != builtin.end();
    if (known || scene::namesFile(name)) return scene::loadScene(name);
    return core::error("\"{}\" is neither a .gltf or .glb file nor a built-in scene ({}, {})", name,
                       fmt::join(builtin, ", "), courtyard::kSceneName);
}

}  // namespace

core::Result<ecs::World> openWorld(const Options& options) {
    TRY(ecs::World world, load(options.scene));
    scene::advanceTo(world, options.time, 0);
    return world;
}

}  // namespace lampyris::sandbox
