#include "view/edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/builtin/shapes.h"
#include "scene/ray_cast.h"
#include "scene/spawn.h"

namespace lampyris::sandbox::view {
namespace {

constexpr float kShare = 0.7f;       // [chosen] of the way to what is looked at
constexpr float kOpenMetres = 4.0f;  // before a camera that looks at nothing
constexpr float kBoxMetres = 0.5f;   // an edge
constexpr float kLightRadius = 0.1f;
constexpr float kFirstWatts = 100.0f;

glm::vec3 placeAhead(const scene::SceneSnapshot& snapshot, const scene::SnapshotCamera& camera) {
    const glm::vec3 eye(camera.cameraToWorld[3]);
    const glm::vec3 ahead = -glm::normalize(glm::vec3(camera.cameraToWorld[2]));
    const auto hit = scene::castRay(snapshot, eye, ahead);
    return eye + (hit ? kShare * hit->distanceMetres : kOpenMetres) * ahead;
}

}  // namespace

glm::vec3 rayThrough(const scene::SnapshotCamera& camera, graph::Extent size, double x, double y) {
    const float tall = std::tan(0.5f * camera.verticalFovRadians);
    const float wide = tall * static_cast<float>(size.width) / static_cast<float>(size.height);
    const glm::vec3 local(
        wide * (2.0f * static_cast<float>(x) / static_cast<float>(size.width) - 1.0f),
        tall * (1.0f - 2.0f * static_cast<float>(y) / static_cast<float>(size.height)), -1.0f);
    return glm::normalize(glm::mat3(camera.cameraToWorld) * local);
}

ecs::Entity pick(const scene::SceneSnapshot& snapshot, const scene::SnapshotCamera& camera,
                 graph::Extent size, double x, double y) {
    const auto hit =
        scene::castRay(snapshot, glm::vec3(camera.cameraToWorld[3]), rayThrough(camera, size, x, y),
                       std::numeric_limits<float>::infinity(), scene::RayCastLights::Hit);
    return hit ? hit->entity : ecs::Entity{};
}

ecs::Entity spawnLightAhead(ecs::World& world, const scene::SceneSnapshot& snapshot,
                            const scene::SnapshotCamera& camera) {
    glm::vec3 watts(0.0f);
    for (const scene::SnapshotLight& light : snapshot.lights) watts += 0.1f * light.powerWatts;
    if (watts == glm::vec3(0.0f)) watts = glm::vec3(kFirstWatts);
    return scene::spawnLight(world, "new light", placeAhead(snapshot, camera),
                             {.radiusMetres = kLightRadius, .powerWatts = watts});
}

ecs::Entity spawnBoxAhead(ecs::World& world, const scene::SceneSnapshot& snapshot,
                          const scene::SnapshotCamera& camera) {
    auto& library = world.resource<scene::Library>();
    const scene::MaterialId grey =
        library.addMaterial(scene::lambertian("new box", glm::vec3(0.6f)));
    scene::Transform transform;
    transform.translation = placeAhead(snapshot, camera);
    assets::Mesh mesh;
    mesh.name = "new box";
    scene::builtin::addBox(mesh, glm::mat4(1.0f), glm::vec3(0.5f * kBoxMetres));
    assets::updateBounds(mesh);
    return scene::spawnMesh(world, std::move(mesh), grey, transform);
}

Movable movableOf(const ecs::World& world, ecs::Entity entity) {
    const auto* transform = world.find<scene::Transform>(entity);
    const auto* light = world.find<scene::SphereLight>(entity);
    return {transform == nullptr ? scene::Transform{} : *transform,
            light == nullptr ? scene::SphereLight{} : *light};
}

bool undone(const Movable& before, const Movable& after, const Movable& now) {
    const auto gone = [&](auto part, auto field) {
        const auto& left = after.*part.*field;
        return before.*part.*field != left && now.*part.*field != left;
    };
    return gone(&Movable::transform, &scene::Transform::translation) ||
           gone(&Movable::transform, &scene::Transform::rotation) ||
           gone(&Movable::transform, &scene::Transform::scale) ||
           gone(&Movable::light, &scene::SphereLight::radiusMetres) ||
           gone(&Movable::light, &scene::SphereLight::powerWatts);
}

std::string nameOf(const ecs::World& world, ecs::Entity entity) {
    const auto* name = world.find<scene::Name>(entity);
    return name == nullptr || name->value.empty() ? "this" : fmt::format("'{}'", name->value);
}

}  // namespace lampyris::sandbox::view
