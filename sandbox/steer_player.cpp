#include "steer_player.h"

#include "courtyard/player.h"

namespace lampyris::sandbox {

void steerPlayer(ecs::World& world, const glm::mat4& cameraToWorld, const window::Input& input,
                 float seconds) {
    const auto axis = [&](int forth, int back) {
        return static_cast<float>(input.held[static_cast<size_t>(forth)]) -
               static_cast<float>(input.held[static_cast<size_t>(back)]);
    };
    // The camera's x is level; away from it is what stands square to that.
    const glm::vec2 right = glm::normalize(glm::vec2(cameraToWorld[0].x, cameraToWorld[0].z));
    const glm::vec2 away(right.y, -right.x);
    const glm::vec2 direction = axis(window::kKeyRight, window::kKeyLeft) * right +
                                axis(window::kKeyUp, window::kKeyDown) * away;
    courtyard::steer(world, direction, seconds);
}

}  // namespace lampyris::sandbox
