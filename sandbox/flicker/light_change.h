/// \file What is done to a scene's strongest light, to see how long that takes to be seen.
#pragma once

#include <optional>

#include "ecs/world.h"
#include "scene/snapshot.h"

namespace lampyris::sandbox::flicker {

/// The sphere light of most power, by its luma; the first of equals. None without sphere lights.
[[nodiscard]] std::optional<scene::SnapshotLight> strongestLight(
    const scene::SceneSnapshot& snapshot);

/// Over the whole sphere; 0 switches it off.
void setPower(ecs::World& world, ecs::Entity light, const glm::vec3& powerWatts);

/// Moves it a fifth of the scene's largest side towards the scene's middle.
void moveInwards(ecs::World& world, const scene::SnapshotLight& light, const math::Bounds& bounds);

/// Whether it gives no light now. A system may have lit it again.
[[nodiscard]] bool isOff(const scene::SnapshotLight& before, const scene::SceneSnapshot& snapshot);

/// Whether the light is elsewhere now. An animation may have put it back.
[[nodiscard]] bool hasMoved(const scene::SnapshotLight& before,
                            const scene::SceneSnapshot& snapshot);

}  // namespace lampyris::sandbox::flicker
