#include "steer_player.h"

#include <gtest/gtest.h>

#include "courtyard/courtyard.h"
#include "courtyard/player.h"
#include "scene/components.h"

namespace lampyris::sandbox {
namespace {

TEST(SteerPlayer, UpIsAwayFromTheCamera) {
    ecs::World world = courtyard::makeCourtyard();
    const auto placeOf = [&] {
        glm::vec3 place(0.0f);
        for (const auto& [entity, player, transform] :
             world.view<courtyard::Player, scene::Transform>())
            place = transform.translation;
        return place;
    };
    // Looks along +x, and down.
    const glm::mat4 camera =
        glm::inverse(glm::lookAt(glm::vec3(0, 2, 0), glm::vec3(3, 1, 0), glm::vec3(0, 1, 0)));
    window::Input input;
    const glm::vec3 start = placeOf();
    steerPlayer(world, camera, input, 0.1f);
    EXPECT_EQ(placeOf(), start) << "no key is held";
    input.held[window::kKeyUp] = true;
    steerPlayer(world, camera, input, 0.1f);
    EXPECT_GT(placeOf().x, start.x + 0.1f);
    EXPECT_NEAR(placeOf().z, start.z, 1e-4f);
    input.held[window::kKeyUp] = false;
    input.held[window::kKeyLeft] = true;
    steerPlayer(world, camera, input, 0.1f);
    EXPECT_LT(placeOf().z, start.z - 0.1f);
}

}  // namespace
}  // namespace lampyris::sandbox
