#include "scene/systems/patrol.h"

#include <gtest/gtest.h>

#include "scene/extract.h"
#include "scene/spawn.h"

namespace lampyris::scene {
namespace {

class Patrols : public testing::Test {
 protected:
    Patrols() {
        world.setResource(Library{});
        lamp = spawnLight(world, "lamp", {}, {0.1f, glm::vec3(1)});
        // A rectangle of 3 × 1, eight metres round.
        world.add(lamp, Patrol{{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}}, 2.0f, 0.0, true});
        Motion motion;
        motion.systems.add("patrol", patrol);
        world.setResource(std::move(motion));
    }
    glm::vec3 at(double seconds) {
        advanceTo(world, seconds, since);
        return world.get<Transform>(lamp).translation;
    }

    ecs::World world;
    ecs::Entity lamp;
    ecs::Tick since = 0;
};

void expectNear(const glm::vec3& a, const glm::vec3& b) {
    EXPECT_LT(glm::distance(a, b), 1e-5f) << a.x << " " << a.y << " " << a.z;
}

TEST_F(Patrols, GoRoundAtAnEvenPace) {
    expectNear(at(0.0), {0, 0, 0});
    expectNear(at(1.0), {2, 0, 0});
    expectNear(at(1.75), {3, 0.5f, 0});
    expectNear(at(3.75), {0, 0.5f, 0});
    expectNear(at(4.5), {1, 0, 0});
    expectNear(at(4001.0), {2, 0, 0});
    expectNear(at(-0.25), {0, 0.5f, 0});
    expectNear(at(1.0), {2, 0, 0});
}

TEST_F(Patrols, GoToAndFroWhereTheWayIsOpen) {
    world.edit<Patrol>(lamp).closed = false;
    expectNear(at(3.0), {1, 1, 0});
    expectNear(at(3.5), {0, 1, 0});
    expectNear(at(4.0), {1, 1, 0});
    expectNear(at(6.5), {1, 0, 0});
    expectNear(at(7.5), {1, 0, 0});
    world.edit<Patrol>(lamp).metresPerSecond = -2.0f;
    expectNear(at(0.5), {1, 0, 0});
}

TEST_F(Patrols, StandWhereThereIsNoWay) {
    world.edit<Patrol>(lamp).waypoints = {{5, 6, 7}};
    EXPECT_EQ(at(3.0), glm::vec3(5, 6, 7));
    world.edit<Patrol>(lamp).closed = false;
    EXPECT_EQ(at(4.0), glm::vec3(5, 6, 7));
    world.edit<Patrol>(lamp).waypoints.assign(3, glm::vec3(1, 2, 3));
    EXPECT_EQ(at(5.0), glm::vec3(1, 2, 3));
    world.edit<Patrol>(lamp).waypoints.clear();
    EXPECT_EQ(at(6.0), glm::vec3(1, 2, 3));
}

TEST_F(Patrols, MoveTheLightOfTheSnapshotAndNothingElse) {
    const ecs::Entity still = spawnLight(world, "still", {9, 9, 9}, {0.1f, glm::vec3(1)});
    at(0.0);
    const SceneSnapshot first = extract(world, {}, 0);
    since = world.advance();
    at(1.0);
    const SceneSnapshot second = extract(world, first, since);
    since = world.advance();
    EXPECT_EQ(second.lights[0].positionWorld, glm::vec3(2, 0, 0));
    EXPECT_GT(second.lights[0].version, first.lights[0].version);
    EXPECT_EQ(second.lights[1].entity, still);
    EXPECT_EQ(second.lights[1].version, first.lights[1].version);
    // The same time again changes nothing.
    at(1.0);
    EXPECT_EQ(extract(world, second, since).lightVersion, second.lightVersion);
}

TEST_F(Patrols, LightsMayChangeWhileTheyMove) {
    at(0.0);
    const SceneSnapshot first = extract(world, {}, 0);
    since = world.advance();
    world.edit<SphereLight>(lamp).radiusMetres = 0.4f;
    world.edit<SphereLight>(lamp).powerWatts = glm::vec3(1, 2, 3);
    at(1.0);
    const SceneSnapshot second = extract(world, first, since);
    EXPECT_EQ(second.lights[0].radiusMetres, 0.4f);
    EXPECT_EQ(second.lights[0].powerWatts, glm::vec3(1, 2, 3));
    EXPECT_GT(second.lightVersion, first.lightVersion);
    EXPECT_EQ(second.geometryVersion, first.geometryVersion);
}

}  // namespace
}  // namespace lampyris::scene
