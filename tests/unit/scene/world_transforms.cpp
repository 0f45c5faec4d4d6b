#include "scene/systems/world_transforms.h"

#include <gtest/gtest.h>

#include "scene/components.h"

namespace lampyris::scene {
namespace {

/// root ─ arm ─ hand, root ─ leg, and a loner.
class WorldTransforms : public testing::Test {
 protected:
    WorldTransforms() {
        root = make({1, 0, 0});
        arm = make({0, 2, 0}, root);
        hand = make({0, 0, 3}, arm);
        leg = make({0, -1, 0}, root);
        loner = make({9, 9, 9});
    }

    ecs::Entity make(const glm::vec3& translation, ecs::Entity parent = {}) {
        const ecs::Entity e = world.create();
        world.add(e, Transform{translation});
        if (parent.valid()) {
            EXPECT_TRUE(ecs::setParent(world, e, parent).ok());
        }
        return e;
    }
    uint32_t update() {
        const uint32_t count = updateWorldTransforms(world, since);
        since = world.advance();
        return count;
    }
    [[nodiscard]] glm::vec3 at(ecs::Entity e) const {
        return glm::vec3(world.get<WorldTransform>(e).matrix[3]);
    }

    ecs::World world;
    ecs::Tick since = 0;
    ecs::Entity root, arm, hand, leg, loner;
};

TEST_F(WorldTransforms, AddUpAlongTheHierarchy) {
    EXPECT_EQ(update(), 5u);
    EXPECT_EQ(at(hand), glm::vec3(1, 2, 3));
    EXPECT_EQ(at(leg), glm::vec3(1, -1, 0));
    EXPECT_EQ(at(loner), glm::vec3(9, 9, 9));
}

TEST_F(WorldTransforms, OnlyWhatIsBelowAChangeIsRecomputed) {
    update();
    EXPECT_EQ(update(), 0u);
    world.edit<Transform>(arm).translation.y = 5.0f;
    EXPECT_EQ(update(), 2u);
    EXPECT_EQ(at(hand), glm::vec3(1, 5, 3));
    world.edit<Transform>(root).scale = glm::vec3(2.0f);
    world.edit<Transform>(hand).translation.z = 1.0f;  // below root: not twice
    EXPECT_EQ(update(), 4u);
    EXPECT_EQ(at(hand), glm::vec3(1, 10, 2));
    EXPECT_EQ(at(loner), glm::vec3(9, 9, 9));
}

TEST_F(WorldTransforms, UnchangedOutcomesAreNotMarkedChanged) {
    update();
    world.edit<Transform>(root).translation.x = 1.0f;
    EXPECT_EQ(updateWorldTransforms(world, since), 4u);
    EXPECT_TRUE(world.changedSince<WorldTransform>(since).empty());
}

TEST_F(WorldTransforms, FollowANewParentAndNone) {
    update();
    ASSERT_TRUE(ecs::setParent(world, arm, loner).ok());
    EXPECT_EQ(update(), 2u);
    EXPECT_EQ(at(hand), glm::vec3(9, 11, 12));
    ecs::clearParent(world, arm);
    EXPECT_EQ(update(), 2u);
    EXPECT_EQ(at(hand), glm::vec3(0, 2, 3));
}

TEST_F(WorldTransforms, AnEntityWithoutTransformPassesItsParentsOn) {
    update();
    world.remove<Transform>(arm);
    EXPECT_EQ(update(), 1u);
    EXPECT_FALSE(world.has<WorldTransform>(arm));
    EXPECT_EQ(at(hand), glm::vec3(1, 0, 3));
    world.add(arm, Transform{{0, 7, 0}});
    EXPECT_EQ(update(), 2u);
    EXPECT_EQ(at(hand), glm::vec3(1, 7, 3));
}

TEST_F(WorldTransforms, DestroyedEntitiesAreNoTrouble) {
    update();
    world.edit<Transform>(hand).translation.x = 1.0f;
    world.destroy(arm);
    EXPECT_EQ(update(), 0u);
}

}  // namespace
}  // namespace lampyris::scene
