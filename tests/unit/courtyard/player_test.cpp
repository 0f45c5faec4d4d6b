#include "courtyard/player.h"

#include <gtest/gtest.h>

#include "courtyard/courtyard.h"
#include "courtyard/floor_plan.h"
#include "scene/builtin/numbers.h"
#include "unit/courtyard/world_facts.h"

namespace lampyris::courtyard {
namespace {

glm::vec3 placeOf(const ecs::World& world) {
    return world.get<scene::Transform>(test::named(world, "player")).translation;
}

void place(ecs::World& world, const glm::vec3& at) {
    world.edit<scene::Transform>(test::named(world, "player")).translation = at;
}

void steerFor(ecs::World& world, const glm::vec2& direction, double seconds) {
    for (int i = 0; i < 30.0 * seconds; ++i) steer(world, direction, 1.0f / 30.0f);
}

TEST(Player, GoesWhereItIsSteeredAndLooksThere) {
    ecs::World world = makeCourtyard();
    const glm::vec3 start = placeOf(world);
    steer(world, {1.0f, 0.0f}, 0.5f);
    const glm::vec3 end = placeOf(world);
    EXPECT_NEAR(end.x - start.x, 0.5f * Player{}.metresPerSecond, 1e-4f);
    EXPECT_EQ(end.z, start.z);
    const glm::quat facing = world.get<scene::Transform>(test::named(world, "player")).rotation;
    EXPECT_NEAR((facing * glm::vec3(0.0f, 0.0f, 1.0f)).x, 1.0f, 1e-5f);
}

TEST(Player, StandsStillWithoutInputAndIsNotMarkedAsChanged) {
    ecs::World world = makeCourtyard();
    const ecs::Tick since = world.advance();
    steer(world, {0.0f, 0.0f}, 1.0f);
    EXPECT_FALSE(world.changedSince<scene::Transform>(test::named(world, "player"), since));
}

TEST(Player, IsNoFasterOnADiagonal) {
    ecs::World world = makeCourtyard();
    const glm::vec3 start = placeOf(world);
    steer(world, {1.0f, 1.0f}, 0.2f);
    EXPECT_NEAR(glm::length(placeOf(world) - start), 0.2f * Player{}.metresPerSecond, 1e-4f);
}

TEST(Player, StopsAtWallsHoweverLongTheStep) {
    ecs::World world = makeCourtyard();
    steer(world, {0.0f, 1.0f}, 100.0f);
    EXPECT_NEAR(placeOf(world).z, kSquare.upper.z - Player{}.radiusMetres, 0.06f);
    steer(world, {-1.0f, 0.0f}, 100.0f);
    EXPECT_NEAR(placeOf(world).x, kSquare.lower.x + Player{}.radiusMetres, 0.06f);
}

TEST(Player, GoesThroughTheDoorAndOnIntoTheStudy) {
    ecs::World world = makeCourtyard();
    place(world, {-5.0f, 0.035f, 0.0f});
    steerFor(world, {-1.0f, 0.0f}, 2.0);
    EXPECT_LT(placeOf(world).x, kDoorway.lower.x) << "in the workshop";
    place(world, {-9.8f, 0.035f, -1.0f});
    steerFor(world, {0.0f, -1.0f}, 2.0);
    EXPECT_LT(placeOf(world).z, kPassage.lower.z) << "in the study";
}

TEST(Player, NeverLeavesTheRoomsOnARandomWalk) {
    ecs::World world = makeCourtyard();
    for (uint32_t i = 0; i < 20'000; ++i) {
        const uint32_t leg = i / 40;
        steer(world,
              {scene::builtin::hashSigned(3, 2 * leg), scene::builtin::hashSigned(3, 2 * leg + 1)},
              1.0f / 15.0f);
        ASSERT_TRUE(isWalkable(placeOf(world), Player{}.radiusMetres)) << i;
    }
}

TEST(Player, WalkableIsWithinARoomAndBesideTheFountain) {
    EXPECT_TRUE(isWalkable({4.0f, 0.0f, 2.0f}, 0.3f));
    EXPECT_TRUE(isWalkable({-7.2f, 0.0f, 0.0f}, 0.3f)) << "the doorway";
    EXPECT_FALSE(isWalkable({-7.2f, 0.0f, 2.6f}, 0.3f)) << "the window";
    EXPECT_FALSE(isWalkable({-7.2f, 0.0f, 5.0f}, 0.3f)) << "a wall";
    EXPECT_FALSE(isWalkable(kFountain, 0.3f));
    EXPECT_FALSE(isWalkable({40.0f, 0.0f, 0.0f}, 0.3f));
}

}  // namespace
}  // namespace lampyris::courtyard
