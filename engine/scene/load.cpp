#include "scene/load.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <utility>

#include "assets/gltf.h"
#include "core/log.h"
#include "scene/builtin/builtin.h"
#include "scene/fallback.h"
#include "scene/instantiate.h"
#include "scene/library.h"
#include "scene/motion.h"
#include "scene/spawn.h"
#include "scene/systems/world_transforms.h"

namespace lampyris::scene {

namespace {

/// Neither so small nor so large that nothing can be seen of it [chosen: floats' squares hold].
bool hasExtent(const glm::mat4& matrix) {
    glm::dvec3 lengths(glm::length(glm::dvec3(matrix[0])), glm::length(glm::dvec3(matrix[1])),
                       glm::length(glm::dvec3(matrix[2])));
    const double largest = std::max({lengths.x, lengths.y, lengths.z});
    const double product = lengths.x * lengths.y * lengths.z;
    const int flat = (lengths.x == 0.0) + (lengths.y == 0.0) + (lengths.z == 0.0);
    return std::isfinite(product) && flat < 2 && largest > 1e-18 && largest < 1e18;
}

/// Nothing may be missing from a picture without a word.
void warnOfPlacements(const ecs::World& world, const std::string& path) {
    size_t meshes = 0;
    for (const auto& [entity, drawn, transform] :
         world.view<MeshInstance, WorldTransform>(ecs::without<Skin>))
        if (!hasExtent(transform.matrix)) ++meshes;
    if (meshes > 0)
        core::logWarning("{}: {} meshes have no extent, or one beyond numbers, and are not drawn",
                         path, meshes);
    for (const auto& [entity, camera, transform] : world.view<Camera, WorldTransform>())
        if (!hasExtent(transform.matrix))
            core::logWarning("{}: a camera's scale is 0, which leaves it no direction", path);
}

core::Result<ecs::World> readFile(const std::string& path) {
    TRY(assets::Model model, assets::loadGltf(path));
    ecs::World world = newWorld();
    instantiate(world, std::move(model), path);
    advanceTo(world, 0.0, 0);
    if (world.count<MeshInstance>() == 0) return core::error("{}: no mesh to draw", path);
    warnOfPlacements(world, path);
    return world;
}

}  // namespace

bool namesFile(const std::string& nameOrPath) {
    std::string ending = std::filesystem::path(nameOrPath).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending == ".gltf" || ending == ".glb";
}

core::Result<ecs::World> readScene(const std::string& nameOrPath) {
    TRY(ecs::World world, namesFile(nameOrPath) ? readFile(nameOrPath) : builtinScene(nameOrPath));
    const auto& library = world.resource<Library>();
    world.setResource(SceneSource{nameOrPath, library.meshes().size(), library.materials().size(),
                                  library.clips().size()});
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
