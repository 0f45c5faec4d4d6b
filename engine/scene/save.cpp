#include "scene/save.h"

#include <utility>

#include "ecs/registry.h"
#include "scene/library.h"
#include "scene/load.h"
#include "scene/registration.h"
#include "scene/systems/world_transforms.h"

namespace lampyris::scene {

using nlohmann::json;

namespace {

constexpr const char* kFormat = "lampyris scene";

const ecs::Registry& registry() {
    static const ecs::Registry kRegistry = [] {
        ecs::Registry made;
        registerComponents(made);
        return made;
    }();
    return kRegistry;
}

core::Result<void> checkReferences(const ecs::World& world, const SceneSource& source) {
    for (const auto& [entity, drawn] : world.view<MeshInstance>()) {
        if (drawn.mesh.valid() && drawn.mesh.value >= source.meshCount) {
            return core::error("entity {}: mesh {} is not one of the {} of {}", entity.index(),
                               drawn.mesh.value, source.meshCount, source.nameOrPath);
        }
        if (drawn.material.valid() && drawn.material.value >= source.materialCount) {
            return core::error("entity {}: material {} is not one of the {} of {}", entity.index(),
                               drawn.material.value, source.materialCount, source.nameOrPath);
        }
    }
    for (const auto& [entity, player] : world.view<AnimationPlayer>()) {
        if (player.clip.valid() && player.clip.value >= source.clipCount)
            return core::error("entity {}: clip {} is not one of the {} of {}", entity.index(),
                               player.clip.value, source.clipCount, source.nameOrPath);
    }
    return {};
}

struct Envelope {
    std::string source;
    std::string world;
};

core::Result<Envelope> open(std::string_view text) {
    const json root = json::parse(text, nullptr, false);
    if (!root.is_object() || root.value("format", json()) != kFormat) {
        return core::error("saved scene: not JSON with \"format\": \"{}\"", kFormat);
    }
    const auto source = root.find("source");
    const auto world = root.find("world");
    if (source == root.end() || !source->is_string() || world == root.end()) {
        return core::error("saved scene: no \"source\" or no \"world\"");
    }
    return Envelope{source->get<std::string>(), world->dump()};
}

}  // namespace

core::Result<std::string> saveScene(const ecs::World& world) {
    const auto& source = world.resource<SceneSource>();
    TRY_VOID(checkReferences(world, source));
    const json root = {{"format", kFormat},
                       {"source", source.nameOrPath},
                       {"world", json::parse(ecs::saveWorld(world, registry()))}};
    return root.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

core::Result<ecs::World> loadSavedScene(std::string_view text) {
    TRY(const Envelope envelope, open(text));
    TRY(ecs::World source, readScene(envelope.source));
    TRY(ecs::World world, ecs::loadWorld(envelope.world, registry()));
    TRY_VOID(checkReferences(world, source.resource<SceneSource>()));
    world.setResource(std::move(source.resource<SceneSource>()));
    world.setResource(std::move(source.resource<Library>()));
    updateWorldTransforms(world);
    return world;
}

}  // namespace lampyris::scene
