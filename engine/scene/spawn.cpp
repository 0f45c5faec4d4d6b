#include "scene/spawn.h"

#include <utility>

#include "scene/motion.h"

namespace lampyris::scene {

ecs::World newWorld() {
    ecs::World world;
    world.setResource(Library{});
    world.setResource(Motion{});
    return world;
}

ecs::Entity spawn(ecs::World& world, std::string name, const Transform& transform) {
    const ecs::Entity entity = world.create();
    world.add(entity, Name{std::move(name)});
    world.add(entity, transform);
    return entity;
}

ecs::Entity spawnMesh(ecs::World& world, assets::Mesh mesh, MaterialId material,
                      const Transform& transform) {
    const ecs::Entity entity = spawn(world, mesh.name, transform);
    const MeshId id = world.resource<Library>().addMesh(std::move(mesh));
    world.add(entity, MeshInstance{id, material});
    return entity;
}

ecs::Entity spawnLight(ecs::World& world, std::string name, const glm::vec3& position,
                       const SphereLight& light) {
    const ecs::Entity entity = spawn(world, std::move(name), Transform{position});
    world.add(entity, light);
    return entity;
}

glm::quat rotationFacing(const glm::dvec3& back) {
    const glm::dvec3 z = glm::normalize(back);
    const glm::dvec3 x = glm::normalize(glm::cross(glm::dvec3(0.0, 1.0, 0.0), z));
    return glm::normalize(glm::quat_cast(glm::mat3(x, glm::cross(z, x), z)));
}

ecs::Entity spawnCamera(ecs::World& world, std::string name, const glm::vec3& eye,
                        const glm::vec3& target, const Camera& camera) {
    const ecs::Entity entity =
        spawn(world, std::move(name), Transform{eye, rotationFacing(eye - target)});
    world.add(entity, camera);
    return entity;
}

assets::Material lambertian(std::string name, const glm::vec3& albedo) {
    assets::Material material;
    material.name = std::move(name);
    material.baseColour = glm::vec4(albedo, 1.0f);
    material.metallic = 0.0f;
    material.specularFactor = 0.0f;
    return material;
}

}  // namespace lampyris::scene
