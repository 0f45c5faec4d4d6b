/// \file Makes entities of the usual kinds.
#pragma once

#include <string>

#include "ecs/world.h"
#include "scene/components.h"
#include "scene/library.h"

namespace lampyris::scene {

/// A world with an empty Library, and a Motion without systems.
[[nodiscard]] ecs::World newWorld();

/// An entity with a name and a transform.
ecs::Entity spawn(ecs::World& world, std::string name, const Transform& transform = {});

/// Puts a mesh into the world's Library and an entity that shows it.
ecs::Entity spawnMesh(ecs::World& world, assets::Mesh mesh, MaterialId material,
                      const Transform& transform = {});

ecs::Entity spawnLight(ecs::World& world, std::string name, const glm::vec3& position,
                       const SphereLight& light);

/// The rotation that turns a camera's +z to `back`, y up; `back` is not vertical.
[[nodiscard]] glm::quat rotationFacing(const glm::dvec3& back);

/// A camera at `eye` that looks at `target`, y up. The two are not on one vertical line.
ecs::Entity spawnCamera(ecs::World& world, std::string name, const glm::vec3& eye,
                        const glm::vec3& target, const Camera& camera = {});

/// Matt paint: no specular reflectance at all.
[[nodiscard]] assets::Material lambertian(std::string name, const glm::vec3& albedo);

}  // namespace lampyris::scene
