/// \file The materials of the courtyard, and how a mesh gets one.
#pragma once

#include <utility>

#include "core/check.h"
#include "scene/spawn.h"

namespace lampyris::courtyard {

/// Matt but for the last three.
struct Paints {
    scene::MaterialId plaster, red, teal, blue, ceiling, tiles, slabs, stone, clay, wood, darkWood,
        green, leaf, iron, linen, crimson, saffron, violet, skin, white, water, copper, glaze;
};

[[nodiscard]] Paints makePaints(scene::Library& library);

/// A mesh that `build(mesh)` fills, shown by an entity of the same name.
template <typename Build>
ecs::Entity show(ecs::World& world, const char* name, scene::MaterialId paint, const Build& build,
                 const scene::Transform& transform = {}) {
    assets::Mesh mesh;
    mesh.name = name;
    build(mesh);
    assets::updateBounds(mesh);
    return scene::spawnMesh(world, std::move(mesh), paint, transform);
}

/// The same below a parent that lives.
template <typename Build>
ecs::Entity showBelow(ecs::World& world, ecs::Entity parent, const char* name,
                      scene::MaterialId paint, const Build& build,
                      const scene::Transform& transform = {}) {
    const ecs::Entity entity = show(world, name, paint, build, transform);
    CHECK(ecs::setParent(world, entity, parent).ok());
    return entity;
}

}  // namespace lampyris::courtyard
