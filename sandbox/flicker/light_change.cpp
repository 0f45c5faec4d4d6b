#include "flicker/light_change.h"

#include <algorithm>

#include "scene/components.h"

namespace lampyris::sandbox::flicker {
namespace {

constexpr float kShareOfScene = 0.2f;  // [chosen] as far as the light of cornell has room

float lumaOf(const glm::vec3& power) {
    return glm::dot(power, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

}  // namespace

std::optional<scene::SnapshotLight> strongestLight(const scene::SceneSnapshot& snapshot) {
    const auto& lights = snapshot.lights;
    const auto strongest = std::max_element(
        lights.begin(), lights.end(),
        [](const auto& a, const auto& b) { return lumaOf(a.powerWatts) < lumaOf(b.powerWatts); });
    if (strongest == lights.end()) return std::nullopt;
    return *strongest;
}

void setPower(ecs::World& world, ecs::Entity light, const glm::vec3& powerWatts) {
    world.edit<scene::SphereLight>(
        light, [&](scene::SphereLight& sphere) { sphere.powerWatts = powerWatts; });
}

void moveInwards(ecs::World& world, const scene::SnapshotLight& light, const math::Bounds& bounds) {
    const glm::vec3 extent = bounds.extent();
    const float reach = kShareOfScene * std::max({extent.x, extent.y, extent.z});
    const glm::vec3 inwards = bounds.centre() - light.positionWorld;
    const float distance = glm::length(inwards);
    const glm::vec3 stepWorld =
        distance > 0.0f ? reach / distance * inwards : glm::vec3(0.0f, -reach, 0.0f);
    scene::Transform local;
    if (const auto* found = world.find<scene::Transform>(light.entity)) local = *found;
    glm::mat4 objectToWorld(1.0f);
    if (const auto* found = world.find<scene::WorldTransform>(light.entity))
        objectToWorld = found->matrix;
    const glm::mat3 parentToWorld(objectToWorld * glm::inverse(local.matrix()));
    local.translation += glm::inverse(parentToWorld) * stepWorld;
    world.set(light.entity, local);
}

bool isOff(const scene::SnapshotLight& before, const scene::SceneSnapshot& snapshot) {
    return std::none_of(snapshot.lights.begin(), snapshot.lights.end(),
                        [&](const scene::SnapshotLight& light) {
                            return light.entity == before.entity && lumaOf(light.powerWatts) > 0.0f;
                        });
}

bool hasMoved(const scene::SnapshotLight& before, const scene::SceneSnapshot& snapshot) {
    return std::any_of(
        snapshot.lights.begin(), snapshot.lights.end(), [&](const scene::SnapshotLight& light) {
            return light.entity == before.entity && light.positionWorld != before.positionWorld;
        });
}

}  // namespace lampyris::sandbox::flicker
