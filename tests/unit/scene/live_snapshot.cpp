#include "scene/live_snapshot.h"

#include <gtest/gtest.h>

#include "scene/builtin/shapes.h"
#include "scene/motion.h"
#include "scene/spawn.h"
#include "scene/systems/patrol.h"

namespace lampyris::scene {
namespace {

void rise(ecs::Write<Transform> place, ecs::With<SphereLight>, const FrameTime& time) {
    place->translation.y = static_cast<float>(time.seconds);
}

TEST(LiveSnapshot, FollowsAWorldFromItsFirstFrameOn) {
    ecs::World world = newWorld();
    const ecs::Entity box = spawnMesh(world, builtin::boxMesh({1, 2, 3}), {});
    spawnLight(world, "lamp", {}, {0.1f, glm::vec3(1.0f)});
    world.resource<Motion>().systems.add("rise", rise);
    LiveSnapshot live;
    EXPECT_TRUE(live.get().instances.empty());

    const SceneSnapshot first = live.follow(world, 2.0);
    ASSERT_EQ(first.instances.size(), 1u);
    EXPECT_EQ(first.boundsWorld.upper, glm::vec3(1, 2, 3));
    EXPECT_EQ(first.lights.at(0).positionWorld.y, 2.0f);

    const SceneSnapshot moved = live.follow(world, 3.0);
    EXPECT_EQ(moved.lights.at(0).positionWorld.y, 3.0f);
    EXPECT_GT(moved.lightVersion, first.lightVersion);
    EXPECT_EQ(moved.geometryVersion, first.geometryVersion);

    world.destroy(box);
    EXPECT_TRUE(live.follow(world, 3.0).instances.empty());
    EXPECT_TRUE(world.removedSince<MeshInstance>(0).empty()) << "what was seen is forgotten";
}

TEST(LiveSnapshot, KeepsEditsOfWhatMovesWhileTimeStandsStill) {
    ecs::World world = newWorld();
    const ecs::Entity lamp = spawnLight(world, "lamp", {}, {0.1f, glm::vec3(1.0f)});
    world.resource<Motion>().systems.add("rise", rise);
    LiveSnapshot live;
    live.follow(world, 2.0);
    world.edit<Transform>(lamp).translation.y = 7.0f;
    EXPECT_EQ(live.followEdits(world).lights.at(0).positionWorld.y, 7.0f);
    EXPECT_EQ(live.followEdits(world).lights.at(0).positionWorld.y, 7.0f);
    spawnMesh(world, builtin::boxMesh({1, 2, 3}), {});
    EXPECT_EQ(live.followEdits(world).instances.size(), 1u) << "with a place of its own";
    EXPECT_EQ(live.follow(world, 2.5).lights.at(0).positionWorld.y, 2.5f);
}

TEST(LiveSnapshot, FollowsHowThingsMoveWhileTimeStandsStill) {
    ecs::World world = newWorld();
    const ecs::Entity lamp = spawnLight(world, "lamp", {}, {0.1f, glm::vec3(1.0f)});
    world.add(lamp, Patrol{{{0, 0, 0}, {4, 0, 0}}, 1.0f});
    world.resource<Motion>().systems.add("patrol", patrol);
    LiveSnapshot live;
    EXPECT_EQ(live.follow(world, 2.0).lights.at(0).positionWorld.x, 2.0f);
    EXPECT_EQ(live.followEdits(world).lights.at(0).positionWorld.x, 2.0f);
    world.edit<Patrol>(lamp).waypoints.back() = {-4, 0, 0};
    EXPECT_EQ(live.followEdits(world).lights.at(0).positionWorld.x, -2.0f);
}

}  // namespace
}  // namespace lampyris::scene
