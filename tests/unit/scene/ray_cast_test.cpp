#include "scene/ray_cast.h"

#include <gtest/gtest.h>

#include "scene/builtin/builtin.h"
#include "scene/builtin/shapes.h"
#include "scene/extract.h"
#include "scene/motion.h"
#include "scene/spawn.h"

namespace lampyris::scene {
namespace {

SceneSnapshot snapshotOf(ecs::World& world) {
    advanceTo(world, 0.0, 0);
    return extract(world, {}, 0);
}

ecs::Entity spawnUnitBox(ecs::World& world, const Transform& transform) {
    assets::Mesh mesh;
    builtin::addBox(mesh, glm::mat4(1.0f), glm::vec3(0.5f));
    assets::updateBounds(mesh);
    return spawnMesh(world, std::move(mesh), kDefaultMaterial, transform);
}

ecs::World emptyWorld() {
    ecs::World world;
    world.setResource(Library{});
    return world;
}

TEST(RayCast, MeetsTheNearerOfTwoBoxesWhereItIs) {
    ecs::World world = emptyWorld();
    Transform far{{0, 0, -5}};
    Transform near{{0, 0, -2}};
    near.scale = {1, 1, 2};
    near.rotation = glm::angleAxis(math::kPi / 2, glm::vec3(0, 1, 0));
    (void)spawnUnitBox(world, far);
    const ecs::Entity nearer = spawnUnitBox(world, near);
    const auto hit = castRay(snapshotOf(world), glm::vec3(0.7f, 0.1f, 0), glm::vec3(0, 0, -1));
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->entity, nearer) << "turned, it is two wide";
    EXPECT_NEAR(hit->distanceMetres, 1.5f, 1e-5f);
    EXPECT_NEAR(hit->positionWorld.z, -1.5f, 1e-5f);
    EXPECT_NEAR(hit->normalWorld.z, 1.0f, 1e-5f);
}

TEST(RayCast, LooksNoFartherThanAsked) {
    ecs::World world = emptyWorld();
    (void)spawnUnitBox(world, Transform{{0, 0, -5}});
    const SceneSnapshot snapshot = snapshotOf(world);
    EXPECT_FALSE(castRay(snapshot, glm::vec3(0), glm::vec3(0, 0, -1), 4.4f));
    EXPECT_TRUE(castRay(snapshot, glm::vec3(0), glm::vec3(0, 0, -1), 4.6f));
    EXPECT_FALSE(castRay(snapshot, glm::vec3(0), glm::vec3(0, 0, 1)));
    EXPECT_FALSE(castRay(snapshot, glm::vec3(2, 0, 0), glm::vec3(0, 0, -1)));
}

TEST(RayCast, MeetsLightsOnlyWhereItIsAskedTo) {
    ecs::World world = emptyWorld();
    (void)spawnUnitBox(world, Transform{{0, 0, -5}});
    const ecs::Entity lamp =
        spawnLight(world, "lamp", {0, 0, -2}, {.radiusMetres = 0.25f, .powerWatts = glm::vec3(1)});
    const SceneSnapshot snapshot = snapshotOf(world);
    EXPECT_FALSE(castRay(snapshot, glm::vec3(0), glm::vec3(0, 0, -1))->isLight);
    const auto hit =
        castRay(snapshot, glm::vec3(0), glm::vec3(0, 0, -1), 100.0f, RayCastLights::Hit);
    ASSERT_TRUE(hit && hit->isLight);
    EXPECT_EQ(hit->entity, lamp);
    EXPECT_NEAR(hit->distanceMetres, 1.75f, 1e-5f);
}

TEST(RayCast, MeetsWhatAPoseHasMoved) {
    ecs::World world = emptyWorld();
    assets::Mesh mesh;
    builtin::addBox(mesh, glm::mat4(1.0f), glm::vec3(0.5f));
    assets::MorphTarget target;
    target.positions.assign(mesh.positions.size(), glm::vec3(0, 0, 3));
    mesh.morphTargets.push_back(target);
    assets::updateBounds(mesh);
    const ecs::Entity box =
        spawnMesh(world, std::move(mesh), kDefaultMaterial, Transform{{0, 0, -5}});
    world.add(box, MorphWeights{{1.0f}});
    const auto hit = castRay(snapshotOf(world), glm::vec3(0.1f, 0.1f, 0), glm::vec3(0, 0, -1));
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distanceMetres, 1.5f, 1e-4f);
}

}  // namespace
}  // namespace lampyris::scene
