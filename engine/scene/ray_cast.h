/// \file One ray through a snapshot on the CPU: for picking, and for standing on the ground.
#pragma once

#include <limits>
#include <optional>

#include "scene/snapshot.h"

namespace lampyris::scene {

struct RayCastHit {
    ecs::Entity entity;
    glm::vec3 positionWorld{0.0f};
    glm::vec3 normalWorld{0.0f};  ///< unit, geometric, against the ray
    float distanceMetres = 0.0f;
    bool isLight = false;  ///< a light's sphere; otherwise a triangle
};

enum class RayCastLights : bool { PassedThrough, Hit };

/// The nearest thing ahead, within `mostMetres`. Every triangle of every instance whose box the ray
/// meets is looked at: right for a ray or two a frame, with no structure to keep. Alpha masks are
/// not looked at.
/// \param direction  unit, world
[[nodiscard]] std::optional<RayCastHit> castRay(
    const SceneSnapshot& snapshot, const glm::vec3& originWorld, const glm::vec3& direction,
    float mostMetres = std::numeric_limits<float>::infinity(),
    RayCastLights lights = RayCastLights::PassedThrough);

}  // namespace lampyris::scene
