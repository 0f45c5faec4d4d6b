// The courtyard against what DESIGN.md promises of it.
#include "courtyard/courtyard.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "courtyard/floor_plan.h"
#include "unit/courtyard/world_facts.h"

namespace lampyris::courtyard {
namespace {

TEST(Courtyard, HasAtLeast100ThousandTrianglesAtAllTimes) {
    ecs::World world = makeCourtyard();
    for (const double seconds : {0.0, 3.0, 17.0, 61.5, 400.0}) {
        test::advance(world, seconds);
        EXPECT_GE(test::triangleCount(world), 100'000u) << seconds;
        EXPECT_LE(test::triangleCount(world), 180'000u) << seconds;
    }
}

TEST(Courtyard, HasFiveOrSixLightsAndTheSixthComesAndGoes) {
    ecs::World world = makeCourtyard();
    std::set<size_t> counts;
    for (int i = 0; i < 400; ++i) {
        test::advance(world, 0.25 * i);
        counts.insert(world.count<scene::SphereLight>());
    }
    EXPECT_EQ(counts, (std::set<size_t>{5, 6}));
}

TEST(Courtyard, HasCamerasByName) {
    const ecs::World world = makeCourtyard();
    for (const char* name : {"square", "workshop", "arcade"})
        EXPECT_TRUE(world.has<scene::Camera>(test::named(world, name))) << name;
    const auto snapshot = scene::extract(world, {}, 0);
    EXPECT_EQ(snapshot.cameras.at(0).name, "square") << "the one that is used unless told";
}

TEST(Courtyard, MeshesAreSound) {
    const ecs::World world = makeCourtyard();
    for (const auto& mesh : world.resource<scene::Library>().meshes()) {
        const assets::Mesh& m = *mesh.value;
        ASSERT_EQ(m.normals.size(), m.positions.size()) << m.name;
        for (const glm::vec3& normal : m.normals)
            ASSERT_NEAR(glm::length(normal), 1.0f, 1e-4f) << m.name;
        for (const uint32_t index : m.indices) ASSERT_LT(index, m.positions.size()) << m.name;
        ASSERT_EQ(m.joints.size(), m.weights.size()) << m.name;
        for (const glm::vec4& weight : m.weights)
            ASSERT_NEAR(weight.x + weight.y + weight.z + weight.w, 1.0f, 1e-5f) << m.name;
        EXPECT_TRUE(m.joints.empty() || m.joints.size() == m.positions.size()) << m.name;
    }
}

TEST(Courtyard, IsTheSameOnEveryCall) {
    ecs::World a = makeCourtyard();
    ecs::World b = makeCourtyard();
    const auto& mine = a.resource<scene::Library>().meshes();
    const auto& other = b.resource<scene::Library>().meshes();
    ASSERT_EQ(mine.size(), other.size());
    for (size_t i = 0; i < mine.size(); ++i) {
        EXPECT_TRUE(mine[i].value->positions == other[i].value->positions);
        EXPECT_TRUE(mine[i].value->normals == other[i].value->normals);
        EXPECT_TRUE(mine[i].value->indices == other[i].value->indices);
    }
    for (const double seconds : {0.0, 2.0, 31.25}) {
        test::advance(a, seconds);
        test::advance(b, seconds);
        EXPECT_EQ(a.entities(), b.entities());
        EXPECT_TRUE(test::lookOf(a) == test::lookOf(b));
    }
}

TEST(Courtyard, IsTheSameAtATimeWhicheverWayItCame) {
    ecs::World straight = makeCourtyard();
    ecs::World around = makeCourtyard();
    ecs::World slow = makeCourtyard();
    test::advance(straight, 5.0);
    for (const double seconds : {10.0, -3.0, 700.0, 5.0}) test::advance(around, seconds);
    for (int i = 0; i <= 160; ++i) test::advance(slow, i / 32.0);
    EXPECT_TRUE(test::lookOf(straight) == test::lookOf(around));
    EXPECT_TRUE(test::lookOf(straight) == test::lookOf(slow));
}

TEST(Courtyard, AnotherSeedBringsOtherVisitors) {
    EXPECT_NE(test::lookOf(makeCourtyard(1)), test::lookOf(makeCourtyard(2)));
}

/// Names of what is drawn or lights, and differs between two times.
std::set<std::string> movingNames() {
    ecs::World world = makeCourtyard();
    std::map<uint32_t, std::string> before;
    for (const ecs::Entity entity : world.entities())
        before[entity.bits] = test::bytesOf(world, entity);
    test::advance(world, 4.2);
    std::set<std::string> moving;
    for (const ecs::Entity entity : world.entities()) {
        const auto found = before.find(entity.bits);
        if (found != before.end() && found->second != test::bytesOf(world, entity))
            moving.insert(world.get<scene::Name>(entity).value);
    }
    return moving;
}

TEST(Courtyard, MovesRigidlyByJointsByMorphingAndInItsLights) {
    const std::set<std::string> moving = movingNames();
    for (const char* name :
         {"lantern", "lantern's light", "door", "mill wheel", "cart", "cart's wheel", "figure",
          "figure's joint", "banner's joint", "basin's water", "bellows", "fire", "firefly"})
        EXPECT_TRUE(moving.contains(name)) << name;
    for (const char* name : {"walls", "fountain", "player", "arcade's light"})
        EXPECT_FALSE(moving.contains(name)) << name;
}

TEST(Courtyard, PosesReachTheSnapshot) {
    ecs::World world = makeCourtyard();
    test::advance(world, 1.0);
    size_t skinned = 0;
    size_t morphed = 0;
    for (const auto& instance : scene::extract(world, {}, 0).instances) {
        if (!instance.pose) continue;
        skinned += instance.pose->jointMatrices.empty() ? 0 : 1;
        morphed += instance.pose->morphWeights.empty() ? 0 : 1;
    }
    EXPECT_GE(skinned, 4u);
    EXPECT_EQ(morphed, 3u);
}

TEST(Courtyard, MeshesComeAndGoAndNothingPilesUp) {
    ecs::World world = makeCourtyard();
    std::set<size_t> meshes;
    size_t most = 0;
    size_t least = SIZE_MAX;
    for (int i = 0; i < 10'000; ++i) {
        test::advance(world, i / 30.0);
        meshes.insert(world.count<scene::MeshInstance>());
        most = std::max(most, world.entityCount());
        least = std::min(least, world.entityCount());
    }
    EXPECT_GT(meshes.size(), 5u);
    EXPECT_LT(most - least, 40u);
    EXPECT_LT(world.entities().back().index(), most + 40) << "slots are used again";
}

}  // namespace
}  // namespace lampyris::courtyard
