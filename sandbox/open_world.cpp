#include "open_world.h"

#include "scene/library.h"
#include "scene/load.h"
#include "scene/motion.h"

namespace lampyris::sandbox {
namespace {

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
    TRY(ecs::World world, scene::loadScene(options.scene));
    TRY_VOID(chooseAnimation(world, options.animation));
    scene::advanceTo(world, options.time, 0);
    return world;
}

}  // namespace lampyris::sandbox
