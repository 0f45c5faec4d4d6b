#include "ecs/hierarchy.h"

#include <gtest/gtest.h>

#include <random>

#include "ecs/world.h"

namespace lampyris::ecs {
namespace {

struct Mark {};

std::vector<Entity> list(std::span<const Entity> entities) {
    return {entities.begin(), entities.end()};
}

class Hierarchy : public testing::Test {
 protected:
    Entity under(Entity parent) {
        const Entity e = world.create();
        world.add<Mark>(e);
        EXPECT_TRUE(setParent(world, e, parent).ok());
        return e;
    }
    World world;
    Entity root = world.create();
};

TEST_F(Hierarchy, KnowsParentsAndChildrenInOrder) {
    const Entity a = under(root);
    const Entity b = under(root);
    const Entity c = under(a);
    EXPECT_EQ(parentOf(world, c), a);
    EXPECT_EQ(list(childrenOf(world, root)), (std::vector<Entity>{a, b}));
    EXPECT_FALSE(parentOf(world, root).valid());
    EXPECT_TRUE(childrenOf(world, b).empty());
    EXPECT_EQ(subtree(world, root), (std::vector<Entity>{root, a, c, b}));
}

TEST_F(Hierarchy, MovesAChildFromParentToParent) {
    const Entity a = under(root);
    const Entity b = under(root);
    const Entity c = under(a);
    const Tick since = world.advance();
    ASSERT_TRUE(setParent(world, c, b).ok());
    EXPECT_TRUE(childrenOf(world, a).empty());
    EXPECT_FALSE(world.has<Children>(a));
    EXPECT_EQ(list(childrenOf(world, b)), std::vector<Entity>{c});
    EXPECT_EQ(world.changedSince<Parent>(since), std::vector<Entity>{c});
    clearParent(world, c);
    clearParent(world, c);
    EXPECT_FALSE(world.has<Parent>(c));
    EXPECT_EQ(world.removedSince<Parent>(since), std::vector<Entity>{c});
}

TEST_F(Hierarchy, SettingTheSameParentChangesNothing) {
    const Entity a = under(root);
    under(root);
    const Tick since = world.advance();
    ASSERT_TRUE(setParent(world, a, root).ok());
    EXPECT_TRUE(world.changedSince<Parent>(since).empty());
    EXPECT_EQ(childrenOf(world, root)[0], a);
}

TEST_F(Hierarchy, RejectsCyclesAndSaysWhich) {
    const Entity a = under(root);
    const Entity b = under(a);
    const auto direct = setParent(world, a, a);
    const auto around = setParent(world, root, b);
    ASSERT_FALSE(direct.ok());
    ASSERT_FALSE(around.ok());
    EXPECT_EQ(around.error().message,
              "entity 0v0 cannot be a child of 2v0: it would be its own ancestor");
    EXPECT_FALSE(parentOf(world, root).valid());
    EXPECT_EQ(parentOf(world, a), root);
    EXPECT_TRUE(isWithin(world, b, root));
    EXPECT_FALSE(isWithin(world, root, b));
}

TEST(HierarchyDeath, DemandsLivingEntities) {
    World world;
    const Entity a = world.create();
    const Entity b = world.create();
    world.destroy(b);
    EXPECT_DEATH(static_cast<void>(setParent(world, a, b)), "none == 1v0");
    EXPECT_DEATH(static_cast<void>(setParent(world, b, a)), "none == 1v0");
}

TEST_F(Hierarchy, DestroysChildrenWithTheirParent) {
    const Entity a = under(root);
    const Entity b = under(a);
    const Entity c = under(root);
    std::vector<Entity> told;
    const Connection connection = world.onRemove<Mark>([&](World& w, Entity e) {
        EXPECT_FALSE(w.alive(a));
        EXPECT_FALSE(w.alive(b));
        told.push_back(e);
    });
    world.destroy(a);
    EXPECT_EQ(told, (std::vector<Entity>{a, b}));
    EXPECT_FALSE(world.alive(b));
    EXPECT_EQ(list(childrenOf(world, root)), std::vector<Entity>{c});
}

TEST_F(Hierarchy, TellsOfTheLostParentWhenTheChildIsDead) {
    const Entity a = under(root);
    int told = 0;
    const Connection connection =
        world.onRemove<Parent>([&](World& w, Entity e, const Parent& parent) {
            EXPECT_EQ(e, a);
            EXPECT_EQ(parent.entity(), root);
            EXPECT_FALSE(w.alive(e));
            EXPECT_TRUE(childrenOf(w, root).empty());
            ++told;
        });
    world.destroy(a);
    EXPECT_EQ(told, 1);
}

TEST_F(Hierarchy, DestroysALongChainAndAWideFamily) {
    Entity last = root;
    for (int i = 0; i < 100000; ++i) last = under(last);
    for (int i = 0; i < 100000; ++i) under(root);
    EXPECT_EQ(world.entityCount(), 200001u);
    world.destroy(root);
    EXPECT_EQ(world.entityCount(), 0u);
    EXPECT_EQ(world.count<Parent>(), 0u);
    EXPECT_EQ(world.count<Children>(), 0u);
}

TEST_F(Hierarchy, PutsParentsFirstAfterRandomMoves) {
    std::mt19937 random(7);
    std::vector<Entity> all{root};
    for (int i = 0; i < 300; ++i) all.push_back(world.create());
    for (int i = 0; i < 3000; ++i) {
        const Entity child = all[random() % all.size()];
        const Entity parent = all[random() % all.size()];
        const bool cycle = isWithin(world, parent, child);
        ASSERT_EQ(setParent(world, child, parent).ok(), !cycle);
        if (i % 10 == 0) clearParent(world, all[random() % all.size()]);
    }
    const std::vector<Entity> order = parentsFirst(world);
    ASSERT_EQ(order.size(), all.size());
    std::vector<bool> seen(all.size(), false);
    for (const Entity e : order) {
        const Entity parent = parentOf(world, e);
        EXPECT_TRUE(!parent.valid() || seen[parent.index()]);
        EXPECT_FALSE(seen[e.index()]);
        seen[e.index()] = true;
        for (const Entity child : childrenOf(world, e)) EXPECT_EQ(parentOf(world, child), e);
    }
}

TEST_F(Hierarchy, IsWholeWhenAnObserverIsTold) {
    const Entity a = under(root);
    const Entity b = under(root);
    const Entity c = under(a);
    const Connection connection = world.onChange<Parent>([&](World& w, Entity e) {
        EXPECT_EQ(parentOf(w, e), b);
        EXPECT_EQ(list(childrenOf(w, b)), std::vector<Entity>{e});
        EXPECT_TRUE(childrenOf(w, a).empty());
        w.destroy(b);
    });
    ASSERT_TRUE(setParent(world, c, b).ok());
    EXPECT_FALSE(world.alive(c));
}

}  // namespace
}  // namespace lampyris::ecs
