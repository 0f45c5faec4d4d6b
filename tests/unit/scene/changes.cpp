#include "scene/changes.h"

#include <gtest/gtest.h>

#include "scene/extract.h"
#include "scene/spawn.h"
#include "scene/systems/world_transforms.h"

namespace lampyris::scene {
namespace {

assets::Mesh unitTriangle() {
    assets::Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.indices = {0, 1, 2};
    assets::updateBounds(mesh);
    return mesh;
}

/// A world with two triangles and two lights, and its snapshots step by step.
class Changes : public ::testing::Test {
 protected:
    Changes() {
        world_.setResource(Library{});
        still_ = spawnMesh(world_, unitTriangle(), kDefaultMaterial, {{5, 0, 0}});
        moving_ = spawnMesh(world_, unitTriangle(), kDefaultMaterial);
        lamp_ = spawnLight(world_, "lamp", {0, 3, 0}, {0.1f, {30, 60, 90}});
        other_ = spawnLight(world_, "other", {4, 3, 0}, {0.1f, {10, 10, 10}});
        (void)step();
    }

    SceneChanges step() {
        updateWorldTransforms(world_, since_);
        SceneSnapshot next = extract(world_, snapshot_, since_);
        since_ = world_.advance();
        SceneChanges changes = changesBetween(snapshot_, next);
        snapshot_ = std::move(next);
        return changes;
    }

    ecs::World world_;
    ecs::Entity still_, moving_, lamp_, other_;
    SceneSnapshot snapshot_;
    ecs::Tick since_ = 0;
};

TEST_F(Changes, NothingMovedIsNone) {
    EXPECT_TRUE(step().none());
}

TEST_F(Changes, AMoveIsABoxAroundBothPlaces) {
    world_.edit<Transform>(moving_).translation = {0, 0, 2};
    const SceneChanges changes = step();
    ASSERT_EQ(changes.regions.size(), 1u);
    EXPECT_EQ(changes.regions[0].boundsWorld.lower, glm::vec3(0, 0, 0));
    EXPECT_EQ(changes.regions[0].boundsWorld.upper, glm::vec3(1, 1, 2));
    EXPECT_FLOAT_EQ(changes.regions[0].movedMetres, 2.0f);
    EXPECT_FALSE(changes.instancesCameOrWent);
    EXPECT_TRUE(changes.lights.empty());
}

TEST_F(Changes, ATurnMovesByItsFarthestCorner) {
    world_.edit<Transform>(moving_).rotation = glm::angleAxis(math::kPi, glm::vec3(0, 0, 1));
    const SceneChanges changes = step();
    ASSERT_EQ(changes.regions.size(), 1u);
    EXPECT_NEAR(changes.regions[0].movedMetres, 2.0f * std::sqrt(2.0f), 1e-5f);
}

TEST_F(Changes, AMeshReplacedCountsWholeThoughItMovesToo) {
    world_.edit<Transform>(moving_).translation = {0, 0, 0.001f};
    world_.resource<Library>().replaceMesh(world_.get<MeshInstance>(moving_).mesh, unitTriangle());
    const SceneChanges changes = step();
    ASSERT_EQ(changes.regions.size(), 1u);
    EXPECT_FLOAT_EQ(changes.regions[0].movedMetres, std::sqrt(2.0f));
}

TEST_F(Changes, WhatCameOrWentIsItsWholeBox) {
    world_.destroy(moving_);
    const SceneChanges gone = step();
    ASSERT_EQ(gone.regions.size(), 1u);
    EXPECT_TRUE(gone.instancesCameOrWent);
    EXPECT_EQ(gone.regions[0].boundsWorld.upper, glm::vec3(1, 1, 0));
    EXPECT_FLOAT_EQ(gone.regions[0].movedMetres, std::sqrt(2.0f));
    spawnMesh(world_, unitTriangle(), kDefaultMaterial, {{0, 0, 7}});
    const SceneChanges came = step();
    ASSERT_EQ(came.regions.size(), 1u);
    EXPECT_TRUE(came.instancesCameOrWent);
    EXPECT_EQ(came.regions[0].boundsWorld.lower, glm::vec3(0, 0, 7));
}

TEST_F(Changes, AReplacedMeshIsItsWholeBox) {
    world_.resource<Library>().replaceMesh(world_.get<MeshInstance>(moving_).mesh, unitTriangle());
    const SceneChanges changes = step();
    ASSERT_EQ(changes.regions.size(), 1u);
    EXPECT_FLOAT_EQ(changes.regions[0].movedMetres, std::sqrt(2.0f));
}

TEST_F(Changes, ALightTellsItsWattsAndItsWay) {
    world_.edit<SphereLight>(lamp_).powerWatts = {60, 60, 60};
    world_.edit<Transform>(other_).translation.x = 7;
    const SceneChanges changes = step();
    ASSERT_EQ(changes.lights.size(), 2u);
    EXPECT_FLOAT_EQ(changes.lights[0].watts, 60.0f);
    EXPECT_FLOAT_EQ(changes.lights[0].changedWatts, 20.0f);
    EXPECT_FLOAT_EQ(changes.lights[0].movedMetres, 0.0f);
    EXPECT_FLOAT_EQ(changes.lights[1].changedWatts, 0.0f);
    EXPECT_FLOAT_EQ(changes.lights[1].movedMetres, 3.0f);
    EXPECT_FALSE(changes.lightsCameOrWent);
}

TEST_F(Changes, ALightThatWentTellsAllItsWatts) {
    world_.destroy(lamp_);
    const SceneChanges changes = step();
    ASSERT_EQ(changes.lights.size(), 1u);
    EXPECT_FLOAT_EQ(changes.lights[0].changedWatts, 60.0f);
    EXPECT_EQ(changes.lights[0].positionWorld, glm::vec3(0, 3, 0));
    EXPECT_TRUE(changes.lightsCameOrWent);
}

TEST_F(Changes, ASlotThatIsAnothersNowIsGoneAndCame) {
    world_.destroy(moving_);
    const ecs::Entity again = spawnMesh(world_, unitTriangle(), kDefaultMaterial, {{0, 0, 3}});
    ASSERT_EQ(again.index(), moving_.index());
    EXPECT_EQ(step().regions.size(), 2u);
}

TEST_F(Changes, MaterialsAreEverything) {
    world_.resource<Library>().replaceMaterial(kDefaultMaterial,
                                               lambertian("other", glm::vec3(0.2f)));
    EXPECT_TRUE(step().everything);
}

TEST_F(Changes, AddUpOverSteps) {
    world_.edit<Transform>(moving_).translation.x = 1;
    SceneChanges changes = step();
    world_.destroy(lamp_);
    add(changes, step());
    EXPECT_EQ(changes.regions.size(), 1u);
    EXPECT_EQ(changes.lights.size(), 1u);
    EXPECT_TRUE(changes.lightsCameOrWent);
}

}  // namespace
}  // namespace lampyris::scene
