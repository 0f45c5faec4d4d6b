/// \file The one who is steered: a little robot that carries a light.
#pragma once

#include "courtyard/paints.h"

namespace lampyris::courtyard {

/// Where it is and where it looks is the game's state, not the clock's.
struct Player {
    float radiusMetres = 0.32f;
    float metresPerSecond = 2.6f;
};

void spawnPlayer(ecs::World& world, const Paints& paints);

/// Whether something of that radius can stand there: within a room or an opening, beside the
/// fountain. A door that is shut holds nobody up.
[[nodiscard]] bool isWalkable(const glm::vec3& position, float radiusMetres);

/// Moves the world's players along `direction` (x east, y south; at most unit length counts) for
/// so many seconds, along a wall where one is in the way. Does nothing in a world without any.
void steer(ecs::World& world, const glm::vec2& direction, float seconds);

}  // namespace lampyris::courtyard
