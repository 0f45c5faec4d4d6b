#include "ecs/commands.h"

#include <gtest/gtest.h>

#include <memory>

namespace lampyris::ecs {
namespace {

struct Score {
    int value = 0;
};
struct Owned {
    std::unique_ptr<int> value;
};

TEST(Commands, DoNothingUntilApplied) {
    World world;
    const Entity e = world.create();
    Commands commands;
    EXPECT_TRUE(commands.empty());
    commands.create();
    commands.add(e, Score{3});
    EXPECT_FALSE(commands.empty());
    EXPECT_EQ(world.entityCount(), 1u);
    EXPECT_FALSE(world.has<Score>(e));
    commands.apply(world);
    EXPECT_EQ(world.entityCount(), 2u);
    EXPECT_EQ(world.get<Score>(e).value, 3);
    EXPECT_TRUE(commands.empty());
}

TEST(Commands, WorkInTheOrderOfTheCalls) {
    World world;
    const Entity e = world.create();
    Commands commands;
    commands.add(e, Score{1});
    commands.remove<Score>(e);
    commands.add(e, Score{2});
    commands.add(e, Score{3});
    commands.apply(world);
    EXPECT_EQ(world.get<Score>(e).value, 3);
}

TEST(Commands, FillEntitiesThatTheyCreate) {
    World world;
    Commands commands;
    const NewEntity parent = commands.create();
    const NewEntity child = commands.create();
    commands.add(child, Owned{std::make_unique<int>(4)});
    commands.setParent(child, parent);
    const std::vector<Entity> created = commands.apply(world);
    ASSERT_EQ(created.size(), 2u);
    EXPECT_EQ(*world.get<Owned>(created[1]).value, 4);
    EXPECT_EQ(parentOf(world, created[1]), created[0]);
}

TEST(Commands, DropWhatIsForADeadEntity) {
    World world;
    const Entity e = world.create();
    const Entity other = world.create();
    Commands commands;
    commands.destroy(e);
    commands.add(e, Score{1});
    commands.remove<Score>(e);
    commands.setParent(other, e);
    commands.destroy(e);
    commands.apply(world);
    EXPECT_FALSE(world.alive(e));
    EXPECT_EQ(world.count<Score>(), 0u);
    EXPECT_FALSE(parentOf(world, other).valid());
}

TEST(Commands, LeaveTheHierarchyAloneWhereACycleWouldForm) {
    World world;
    const Entity a = world.create();
    const Entity b = world.create();
    Commands commands;
    commands.setParent(b, a);
    commands.setParent(a, b);
    commands.apply(world);
    EXPECT_EQ(parentOf(world, b), a);
    EXPECT_FALSE(parentOf(world, a).valid());
}

TEST(Commands, MayBeRecordedByTheObserversOfTheirOwnChanges) {
    World world;
    Commands commands;
    const Connection chain = world.onAdd<Score>([&](World& w, Entity e) {
        const int value = w.get<Score>(e).value;
        if (value > 0) commands.add(commands.create(), Score{value - 1});
    });
    commands.add(commands.create(), Score{3});
    int rounds = 0;
    for (; !commands.empty(); ++rounds) commands.apply(world);
    EXPECT_EQ(rounds, 4);
    EXPECT_EQ(world.count<Score>(), 4u);
}

}  // namespace
}  // namespace lampyris::ecs
