#include "scene/mirror.h"

#include <gtest/gtest.h>

#include "scene/live_snapshot.h"
#include "scene/spawn.h"

namespace lampyris::scene {
namespace {

/// A game's storage: an array of whatever the game likes.
struct Storage : EntitySource {
    void forEach(const std::function<void(const EntityState&)>& show) const override {
        for (const EntityState& state : states) show(state);
    }
    std::vector<EntityState> states;
};

assets::Mesh triangle() {
    assets::Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.indices = {0, 1, 2};
    assets::updateBounds(mesh);
    return mesh;
}

class MirrorTest : public testing::Test {
 protected:
    MirrorTest() {
        world.setResource(Library{});
        mesh = {world.resource<Library>().addMesh(triangle()), {}};
        storage.states = {{.id = 1ull << 40, .mesh = mesh},
                          {.id = 7, .transform = {{5, 0, 0}}, .mesh = mesh},
                          {.id = 9, .light = SphereLight{0.1f, glm::vec3(10.0f)}},
                          {.id = 0, .name = "eye", .transform = {{0, 0, 4}}, .camera = Camera{}}};
        follow();
    }

    Mirror::Counts follow() {
        const Mirror::Counts counts = mirror.follow(world, storage);
        changedTransforms = world.changedSince<Transform>(world.tick() - 1).size();
        changedLights = world.changedSince<SphereLight>(world.tick() - 1).size();
        before = live.get();
        now = live.follow(world, 0.0);
        return counts;
    }

    ecs::World world;
    MeshInstance mesh;
    Storage storage;
    Mirror mirror;
    LiveSnapshot live;
    size_t changedTransforms = 0, changedLights = 0;
    SceneSnapshot before, now;
};

TEST_F(MirrorTest, ShowsAllThatIsThere) {
    EXPECT_EQ(world.entityCount(), 4u);
    ASSERT_EQ(now.instances.size(), 2u);
    EXPECT_EQ(now.instances[1].entity, mirror.entityOf(7));
    EXPECT_EQ(now.instances[1].objectToWorld[3].x, 5.0f);
    ASSERT_EQ(now.lights.size(), 1u);
    EXPECT_EQ(now.lights[0].powerWatts, glm::vec3(10.0f));
    ASSERT_EQ(now.cameras.size(), 1u);
    EXPECT_EQ(now.cameras[0].name, "eye");
    EXPECT_EQ(now.cameras[0].cameraToWorld[3].z, 4.0f);
    EXPECT_FALSE(mirror.entityOf(8).valid());
}

TEST_F(MirrorTest, WhatIsAsItWasCarriesNoNewTick) {
    EXPECT_EQ(follow(), Mirror::Counts{});
    EXPECT_EQ(changedTransforms, 0u);
    EXPECT_EQ(changedLights, 0u);
    EXPECT_TRUE(world.changedSince<MeshInstance>(1).empty());
    EXPECT_TRUE(world.changedSince<Camera>(1).empty());
    EXPECT_TRUE(world.changedSince<Name>(1).empty());
    EXPECT_TRUE(world.removedSince<SphereLight>(0).empty());
    EXPECT_EQ(now.geometryVersion, before.geometryVersion);
    EXPECT_EQ(now.lightVersion, before.lightVersion);
}

TEST_F(MirrorTest, AMoveEditsOneTransform) {
    storage.states[1].transform.translation.x = 6.0f;
    EXPECT_EQ(follow(), (Mirror::Counts{.changed = 1}));
    EXPECT_EQ(changedTransforms, 1u);
    EXPECT_EQ(now.instances[0].version, before.instances[0].version);
    EXPECT_GT(now.instances[1].version, before.instances[1].version);
    EXPECT_EQ(now.instances[1].objectToWorld[3].x, 6.0f);
    EXPECT_EQ(now.lightVersion, before.lightVersion);
}

TEST_F(MirrorTest, ALightThatChangesLeavesGeometryAlone) {
    storage.states[2].light->powerWatts.g = 2.0f;
    EXPECT_EQ(follow(), (Mirror::Counts{.changed = 1}));
    EXPECT_EQ(changedTransforms, 0u);
    EXPECT_EQ(changedLights, 1u);
    EXPECT_GT(now.lightVersion, before.lightVersion);
    EXPECT_EQ(now.geometryVersion, before.geometryVersion);
}

TEST_F(MirrorTest, ThingsComeAndGoAndKeepTheirEntities) {
    const ecs::Entity kept = mirror.entityOf(7);
    const ecs::Entity gone = mirror.entityOf(1ull << 40);
    storage.states[0] = {.id = 11, .mesh = mesh};
    std::swap(storage.states[0], storage.states[1]);  // the order means nothing
    EXPECT_EQ(follow(), (Mirror::Counts{.added = 1, .removed = 1}));
    EXPECT_FALSE(world.alive(gone));
    EXPECT_FALSE(mirror.entityOf(1ull << 40).valid());
    EXPECT_EQ(mirror.entityOf(7), kept);
    EXPECT_EQ(now.instances.size(), 2u);
    storage.states.clear();
    EXPECT_EQ(follow(), (Mirror::Counts{.removed = 4}));
    EXPECT_EQ(world.entityCount(), 0u);
    EXPECT_TRUE(now.instances.empty() && now.lights.empty() && now.cameras.empty());
}

TEST_F(MirrorTest, ComponentsComeAndGo) {
    storage.states[1].mesh.reset();
    storage.states[1].light = SphereLight{0.2f, glm::vec3(1.0f)};
    storage.states[3].name = "other";
    EXPECT_EQ(follow(), (Mirror::Counts{.changed = 2}));
    EXPECT_EQ(now.instances.size(), 1u);
    EXPECT_EQ(now.lights.size(), 2u);
    EXPECT_EQ(now.cameras[0].name, "other");
    EXPECT_EQ(follow(), Mirror::Counts{});
}

TEST_F(MirrorTest, WhatTheGameAddsToAnEntityStays) {
    world.add(mirror.entityOf(7), MorphWeights{{0.5f}});
    storage.states[1].transform.translation.y = 1.0f;
    follow();
    EXPECT_TRUE(world.has<MorphWeights>(mirror.entityOf(7)));
}

TEST_F(MirrorTest, WhatIsStillShownOutlivesItsParent) {
    const ecs::Entity parent = mirror.entityOf(1ull << 40);
    const ecs::Entity child = mirror.entityOf(7);
    const ecs::Entity below = mirror.entityOf(9);
    const ecs::Entity between = spawn(world, "the game's own");
    const ecs::Entity eye = mirror.entityOf(0);
    ASSERT_TRUE(ecs::setParent(world, child, parent).ok());
    ASSERT_TRUE(ecs::setParent(world, below, child).ok());
    ASSERT_TRUE(ecs::setParent(world, between, parent).ok());
    ASSERT_TRUE(ecs::setParent(world, eye, between).ok());
    follow();
    storage.states.erase(storage.states.begin());
    EXPECT_EQ(follow(), (Mirror::Counts{.removed = 1}));
    EXPECT_FALSE(world.alive(parent));
    EXPECT_FALSE(world.alive(between));
    for (const uint64_t id : {uint64_t{7}, uint64_t{9}, uint64_t{0}})
        EXPECT_TRUE(world.alive(mirror.entityOf(id))) << id;
    EXPECT_EQ(mirror.entityOf(7), child);
    EXPECT_FALSE(ecs::parentOf(world, child).valid());
    EXPECT_EQ(ecs::parentOf(world, below), child) << "a family that stays, stays together";
    EXPECT_FALSE(ecs::parentOf(world, eye).valid());
    EXPECT_EQ(now.instances.size(), 1u);
    EXPECT_EQ(now.instances[0].objectToWorld[3].x, 5.0f);
    EXPECT_EQ(follow(), Mirror::Counts{});
}

TEST_F(MirrorTest, ParentsAndChildrenLeaveTogether) {
    ASSERT_TRUE(ecs::setParent(world, mirror.entityOf(7), mirror.entityOf(1ull << 40)).ok());
    storage.states.erase(storage.states.begin(), storage.states.begin() + 2);
    EXPECT_EQ(follow(), (Mirror::Counts{.removed = 2}));
    EXPECT_EQ(world.entityCount(), 2u);
}

TEST_F(MirrorTest, AnEntityThatSomebodyDestroyedComesBack) {
    world.destroy(mirror.entityOf(7));
    EXPECT_EQ(follow(), (Mirror::Counts{.added = 1}));
    EXPECT_TRUE(world.alive(mirror.entityOf(7)));
    EXPECT_EQ(now.instances.size(), 2u);
}

TEST_F(MirrorTest, AnIdOfTwoThingsIsAMistake) {
    storage.states[0].id = 7;
    EXPECT_DEATH(mirror.follow(world, storage), "known.round != round_");
}

}  // namespace
}  // namespace lampyris::scene
