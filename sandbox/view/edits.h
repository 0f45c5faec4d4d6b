/// \file What the user does to the world: pick, spawn, edit.
#pragma once

#include "ecs/world.h"
#include "graph/resource.h"
#include "scene/components.h"
#include "scene/snapshot.h"

namespace lampyris::sandbox::view {

/// Unit direction, world, of the ray through a pixel's place.
[[nodiscard]] glm::vec3 rayThrough(const scene::SnapshotCamera& camera, graph::Extent size,
                                   double x, double y);

/// What is seen at a pixel, lights too; none where nothing is.
[[nodiscard]] ecs::Entity pick(const scene::SceneSnapshot& snapshot,
                               const scene::SnapshotCamera& camera, graph::Extent size, double x,
                               double y);

/// In front of what the camera looks at. The light has a tenth of all lights' power, 100 W where
/// there are none; the box is half a metre wide, in matt grey.
ecs::Entity spawnLightAhead(ecs::World& world, const scene::SceneSnapshot& snapshot,
                            const scene::SnapshotCamera& camera);
ecs::Entity spawnBoxAhead(ecs::World& world, const scene::SceneSnapshot& snapshot,
                          const scene::SnapshotCamera& camera);

/// What both an animation and the user may change of an entity; as by default where it has not got
/// it.
struct Movable {
    scene::Transform transform;
    scene::SphereLight light;
};
[[nodiscard]] Movable movableOf(const ecs::World& world, ecs::Entity entity);
/// Whether something that an edit changed is no longer as it left it.
[[nodiscard]] bool undone(const Movable& before, const Movable& after, const Movable& now);

/// For the user: its name in quotes, or "this".
[[nodiscard]] std::string nameOf(const ecs::World& world, ecs::Entity entity);

}  // namespace lampyris::sandbox::view
