#include "open_world.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "courtyard/courtyard.h"
#include "scene/builtin/builtin.h"
#include "scene/library.h"
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

core::Result<void> chooseAnimation(ecs::World& world, const std::string& name) {
    if (name.empty()) return {};
    const auto& clips = world.resource<scene::Library>().clips();
    std::string names;
    for (uint32_t i = 0; i < clips.size(); ++i) {
        names += fmt::format("{}'{}'", names.empty() ? "" : ", ", clips[i]->name);
        if (clips[i]->name != name) continue;
        for (const auto& [entity, player] : world.view<scene::AnimationPlayer>())
            world.edit<scene::AnimationPlayer>(entity).clip = {i};
        return {};
    }
    return core::error("--animation {}: the scene has no such animation; it has {}", name,
                       names.empty() ? "none" : names);
}

}  // namespace

core::Result<ecs::World> openWorld(const Options& options) {
    TRY(ecs::World world, load(options.scene));
    TRY_VOID(chooseAnimation(world, options.animation));
    scene::advanceTo(world, options.time, 0);
    return world;
}

}  // namespace lampyris::sandbox
