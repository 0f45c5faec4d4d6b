#include "scene/extract.h"

#include <gtest/gtest.h>

#include <limits>

#include "scene/spawn.h"
#include "scene/systems/world_transforms.h"

namespace lampyris::scene {
namespace {

assets::Mesh triangle(const std::string& name) {
    assets::Mesh mesh;
    mesh.name = name;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.indices = {0, 1, 2};
    assets::updateBounds(mesh);
    return mesh;
}

class Extract : public testing::Test {
 protected:
    Extract() {
        world.setResource(Library{});
        paint = library().addMaterial(lambertian("paint", glm::vec3(0.5f)));
        first = spawnMesh(world, triangle("first"), paint);
        second = spawnMesh(world, triangle("second"), paint, Transform{{10, 0, 0}});
        light = spawnLight(world, "light", {0, 5, 0}, {0.1f, glm::vec3(7.0f)});
        spawnCamera(world, "eye", {0, 0, 4}, {0, 0, 0});
        update();
    }

    Library& library() { return world.resource<Library>(); }
    const SceneSnapshot& update() {
        updateWorldTransforms(world, since);
        before = std::move(now);
        now = extract(world, before, since);
        since = world.advance();
        return now;
    }

    ecs::World world;
    ecs::Tick since = 0;
    MaterialId paint;
    ecs::Entity first, second, light;
    SceneSnapshot before, now;
};

TEST_F(Extract, HoldsAllThatIsDrawn) {
    ASSERT_EQ(now.instances.size(), 2u);
    EXPECT_EQ(now.instances[0].entity, first);
    EXPECT_EQ(now.instances[1].entity, second);
    EXPECT_EQ(now.meshes[now.instances[1].mesh].value->name, "second");
    EXPECT_EQ(now.materials[now.instances[0].material].value->name, "paint");
    EXPECT_EQ(now.instances[1].objectToWorld[3], glm::vec4(10, 0, 0, 1));
    ASSERT_EQ(now.lights.size(), 1u);
    EXPECT_EQ(now.lights[0].positionWorld, glm::vec3(0, 5, 0));
    EXPECT_EQ(now.lights[0].powerWatts, glm::vec3(7.0f));
    ASSERT_EQ(now.cameras.size(), 1u);
    EXPECT_EQ(now.cameras[0].name, "eye");
    EXPECT_EQ(now.boundsWorld.lower, glm::vec3(0, 0, 0));
    EXPECT_EQ(now.boundsWorld.upper, glm::vec3(11, 1, 0));
}

TEST_F(Extract, NothingChangedKeepsVersionsAndSharesGeometry) {
    update();
    EXPECT_EQ(now.geometryVersion, before.geometryVersion);
    EXPECT_EQ(now.lightVersion, before.lightVersion);
    EXPECT_EQ(now.materialVersion, before.materialVersion);
    EXPECT_EQ(now.instances[0].version, before.instances[0].version);
    EXPECT_EQ(now.meshes[0].value.get(), before.meshes[0].value.get());
}

TEST_F(Extract, AMoveTouchesOneInstanceAndTheBounds) {
    world.edit<Transform>(second).translation.x = 20.0f;
    update();
    EXPECT_GT(now.geometryVersion, before.geometryVersion);
    EXPECT_EQ(now.lightVersion, before.lightVersion);
    EXPECT_EQ(now.instances[0].version, before.instances[0].version);
    EXPECT_GT(now.instances[1].version, before.instances[1].version);
    EXPECT_EQ(now.boundsWorld.upper.x, 21.0f);
}

TEST_F(Extract, TheSameValueAgainIsNoChange) {
    world.set(first, MeshInstance(world.get<MeshInstance>(first)));
    world.set(light, SphereLight(world.get<SphereLight>(light)));
    update();
    EXPECT_EQ(now.geometryVersion, before.geometryVersion);
    EXPECT_EQ(now.lightVersion, before.lightVersion);
}

TEST_F(Extract, ALightChangesAlone) {
    world.edit<SphereLight>(light).powerWatts = glm::vec3(1, 2, 3);
    update();
    EXPECT_GT(now.lightVersion, before.lightVersion);
    EXPECT_GT(now.lights[0].version, before.lights[0].version);
    EXPECT_EQ(now.lights[0].powerWatts, glm::vec3(1, 2, 3));
    EXPECT_EQ(now.geometryVersion, before.geometryVersion);
}

TEST_F(Extract, ALightHasSomeRadius) {
    for (const float radius : {0.0f, 1e-30f, -1.0f, std::numeric_limits<float>::quiet_NaN()}) {
        world.edit<SphereLight>(light).radiusMetres = radius;
        EXPECT_EQ(update().lights[0].radiusMetres, 1e-6f) << radius;
    }
}

TEST_F(Extract, EntitiesComeAndGoInTheOrderOfTheirSlots) {
    const ecs::Entity third = spawnMesh(world, triangle("third"), paint, Transform{{0, 3, 0}});
    update();
    ASSERT_EQ(now.instances.size(), 3u);
    EXPECT_EQ(now.instances[2].entity, third);
    EXPECT_EQ(now.boundsWorld.upper.y, 4.0f);
    EXPECT_EQ(now.instances[0].version, before.instances[0].version);
    world.destroy(first);
    update();
    ASSERT_EQ(now.instances.size(), 2u);
    EXPECT_EQ(now.instances[0].entity, second);
    EXPECT_GT(now.geometryVersion, before.geometryVersion);
    // The freed slot is used again: the newcomer stands where the dead one stood.
    const ecs::Entity reborn = spawnMesh(world, triangle("reborn"), paint);
    ASSERT_EQ(reborn.index(), first.index());
    update();
    ASSERT_EQ(now.instances.size(), 3u);
    EXPECT_EQ(now.instances[0].entity, reborn);
    EXPECT_EQ(now.meshes[now.instances[0].mesh].value->name, "reborn");
}

TEST_F(Extract, DyingAndRebirthWithinOneTickAreSeen) {
    world.destroy(first);
    const ecs::Entity reborn = spawnMesh(world, triangle("reborn"), paint);
    ASSERT_EQ(reborn.index(), first.index());
    update();
    ASSERT_EQ(now.instances.size(), 2u);
    EXPECT_EQ(now.instances[0].entity, reborn);
    EXPECT_GT(now.instances[0].version, before.instances[0].version);
}

TEST_F(Extract, RemovedComponentsLeave) {
    world.remove<SphereLight>(light);
    world.remove<MeshInstance>(second);
    update();
    EXPECT_TRUE(now.lights.empty());
    EXPECT_GT(now.lightVersion, before.lightVersion);
    EXPECT_EQ(now.instances.size(), 1u);
    EXPECT_EQ(now.boundsWorld.upper, glm::vec3(1, 1, 0));
}

TEST_F(Extract, AReplacedMeshIsToldByVersions) {
    assets::Mesh larger = triangle("larger");
    larger.positions[1] = {4, 0, 0};
    assets::updateBounds(larger);
    library().replaceMesh(world.get<MeshInstance>(first).mesh, std::move(larger));
    update();
    EXPECT_GT(now.geometryVersion, before.geometryVersion);
    EXPECT_GT(now.instances[0].version, before.instances[0].version);
    EXPECT_EQ(now.instances[1].version, before.instances[1].version);
    EXPECT_EQ(now.instances[0].boundsWorld.upper.x, 4.0f);
    EXPECT_EQ(now.meshes[1].value.get(), before.meshes[1].value.get());
    EXPECT_EQ(before.meshes[0].value->name, "first");
}

TEST_F(Extract, AReplacedMaterialLeavesGeometryAlone) {
    library().replaceMaterial(paint, lambertian("other", glm::vec3(0.1f)));
    update();
    EXPECT_GT(now.materialVersion, before.materialVersion);
    EXPECT_EQ(now.geometryVersion, before.geometryVersion);
    EXPECT_EQ(now.materials[paint.value].value->name, "other");
}

TEST_F(Extract, NoMaterialIsTheDefaultAndNoMeshIsNotDrawn) {
    world.edit<MeshInstance>(first).material = {};
    world.edit<MeshInstance>(second).mesh = {};
    update();
    ASSERT_EQ(now.instances.size(), 1u);
    EXPECT_EQ(now.instances[0].material, kDefaultMaterial.value);
}

TEST_F(Extract, CamerasAreRigidUnderScaleAndMirror) {
    const ecs::Entity tiny =
        spawn(world, "tiny", Transform{{1, 2, 3}, {1, 0, 0, 0}, {-1e-12f, 1e-12f, 1e-12f}});
    world.add(tiny, Camera{});
    update();
    ASSERT_EQ(now.cameras.size(), 2u);
    const glm::mat3 turn(now.cameras[1].cameraToWorld);
    EXPECT_NEAR(glm::determinant(turn), 1.0f, 1e-5f);
    EXPECT_EQ(glm::vec3(now.cameras[1].cameraToWorld[3]), glm::vec3(1, 2, 3));
}

TEST_F(Extract, ASpotShinesAlongItsMinusZ) {
    const ecs::Entity spot = spawnLight(world, "spot", {}, {0.1f, glm::vec3(1), 0.5f, 0.8f});
    // A quarter turn about y takes −z to −x.
    world.edit<Transform>(spot).rotation = glm::angleAxis(0.5f * math::kPi, glm::vec3(0, 1, 0));
    update();
    ASSERT_EQ(now.lights.size(), 2u);
    EXPECT_NEAR(glm::distance(now.lights[1].directionWorld, glm::vec3(-1, 0, 0)), 0.0f, 1e-6f);
    EXPECT_EQ(now.lights[1].cosOuterCone, 0.5f);
}

TEST_F(Extract, ShowsNothingForAMeshAndTheDefaultForAMaterialThatTheLibraryLacks) {
    world.set(first, MeshInstance{MeshId{99}, paint});
    world.set(second, MeshInstance{world.get<MeshInstance>(second).mesh, MaterialId{99}});
    update();
    ASSERT_EQ(now.instances.size(), 1u);
    EXPECT_EQ(now.instances.front().entity, second);
    EXPECT_EQ(now.instances.front().material, kDefaultMaterial.value);
}

}  // namespace
}  // namespace lampyris::scene
