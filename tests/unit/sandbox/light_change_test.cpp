#include "flicker/light_change.h"

#include <gtest/gtest.h>

#include "ecs/hierarchy.h"
#include "scene/extract.h"
#include "scene/motion.h"
#include "scene/spawn.h"

namespace lampyris::sandbox::flicker {
namespace {

ecs::World emptyWorld() {
    ecs::World world;
    world.setResource(scene::Library{});
    return world;
}

scene::SceneSnapshot snapshotOf(ecs::World& world) {
    scene::advanceTo(world, 0.0, 0);
    return scene::extract(world, {}, 0);
}

constexpr math::Bounds kRoom{glm::vec3(-5.0f, 0.0f, -5.0f), glm::vec3(5.0f, 10.0f, 5.0f)};

TEST(LightChange, FindsTheStrongestLight) {
    ecs::World world = emptyWorld();
    EXPECT_FALSE(strongestLight(snapshotOf(world)).has_value());
    scene::spawnLight(world, "blue", glm::vec3(0.0f), {0.1f, glm::vec3(0.0f, 0.0f, 900.0f)});
    const auto green =
        scene::spawnLight(world, "green", glm::vec3(0.0f), {0.1f, glm::vec3(0.0f, 100.0f, 0.0f)});
    scene::spawnLight(world, "as strong", glm::vec3(0.0f), {0.1f, glm::vec3(0.0f, 100.0f, 0.0f)});
    EXPECT_EQ(strongestLight(snapshotOf(world))->entity, green) << "blue is dark to the eye";
}

TEST(LightChange, SwitchesItOffAndOn) {
    ecs::World world = emptyWorld();
    const auto light = scene::spawnLight(world, "light", glm::vec3(0.0f), {0.1f, glm::vec3(7.0f)});
    setPower(world, light, glm::vec3(0.0f));
    EXPECT_EQ(snapshotOf(world).lights.at(0).powerWatts, glm::vec3(0.0f));
    setPower(world, light, glm::vec3(7.0f));
    EXPECT_EQ(snapshotOf(world).lights.at(0).powerWatts, glm::vec3(7.0f));
}

TEST(LightChange, MovesItAFifthTowardsTheMiddle) {
    ecs::World world = emptyWorld();
    scene::spawnLight(world, "light", glm::vec3(0.0f, 8.5f, 0.0f), {0.1f, glm::vec3(7.0f)});
    const auto before = snapshotOf(world).lights.at(0);
    EXPECT_FALSE(hasMoved(before, snapshotOf(world)));
    moveInwards(world, before, kRoom);
    const auto after = snapshotOf(world);
    EXPECT_TRUE(hasMoved(before, after));
    EXPECT_NEAR(after.lights.at(0).positionWorld.y, 6.5f, 1e-5f);
}

TEST(LightChange, MovesItInTheWorldWhateverItsParent) {
    ecs::World world = emptyWorld();
    const auto parent =
        scene::spawn(world, "turned",
                     {glm::vec3(1.0f, 2.0f, 3.0f),
                      glm::angleAxis(1.0f, glm::vec3(0.0f, 0.0f, 1.0f)), glm::vec3(2.0f)});
    const auto light =
        scene::spawnLight(world, "light", glm::vec3(0.5f, 1.0f, 0.0f), {0.1f, glm::vec3(7.0f)});
    ASSERT_TRUE(ecs::setParent(world, light, parent).ok());
    const auto before = snapshotOf(world).lights.at(0);
    moveInwards(world, before, kRoom);
    const glm::vec3 moved = snapshotOf(world).lights.at(0).positionWorld - before.positionWorld;
    const glm::vec3 wanted = 2.0f * glm::normalize(kRoom.centre() - before.positionWorld);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(moved[i], wanted[i], 1e-4f);
}

}  // namespace
}  // namespace lampyris::sandbox::flicker
