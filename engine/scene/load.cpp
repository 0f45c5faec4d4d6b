#include "scene/load.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

#include "assets/gltf.h"
#include "scene/builtin/builtin.h"
#include "scene/fallback.h"
#include "scene/instantiate.h"
#include "scene/library.h"
#include "scene/systems/world_transforms.h"

namespace lampyris::scene {

namespace {

bool looksLikeGltf(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending == ".gltf" || ending == ".glb";
}

core::Result<ecs::World> readFile(const std::string& path) {
    TRY(assets::Model model, assets::loadGltf(path));
    ecs::World world;
    world.setResource(Library{});
    instantiate(world, std::move(model), path);
    updateWorldTransforms(world);
    if (world.count<MeshInstance>() == 0) return core::error("{}: no mesh to draw", path);
    return world;
}

}  // namespace

core::Result<ecs::World> readScene(const std::string& nameOrPath) {
    TRY(ecs::World world,
        looksLikeGltf(nameOrPath) ? readFile(nameOrPath) : builtinScene(nameOrPath));
    const auto& library = world.resource<Library>();
    world.setResource(SceneSource{nameOrPath, library.meshes().size(), library.materials().size()});
    return world;
}

core::Result<ecs::World> loadScene(const std::string& nameOrPath) {
    TRY(ecs::World world, readScene(nameOrPath));
    addMissingCamera(world, nameOrPath);
    addMissingLight(world, nameOrPath);
    updateWorldTransforms(world);
    return world;
}

}  // namespace lampyris::scene
