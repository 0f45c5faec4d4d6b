#include "ecs/world.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <thread>

namespace lampyris::ecs {
namespace {

struct Position {
    int x = 0;
};
struct Label {
    std::string text;
};
struct Tag {};
struct Owned {
    std::unique_ptr<int> value;
};

TEST(World, GivesEachEntityItsOwnHandle) {
    World world;
    const Entity a = world.create();
    const Entity b = world.create();
    EXPECT_NE(a, b);
    EXPECT_TRUE(world.alive(a));
    EXPECT_FALSE(world.alive(Entity{}));
    EXPECT_EQ(world.entityCount(), 2u);
    EXPECT_EQ(world.entities(), (std::vector<Entity>{a, b}));
}

TEST(World, DetectsAStaleHandleThoughItsSlotIsUsedAgain) {
    World world;
    const Entity old = world.create();
    world.add(old, Position{1});
    EXPECT_TRUE(world.destroy(old));
    const Entity reused = world.create();
    ASSERT_EQ(reused.index(), old.index());
    world.add(reused, Position{2});

    EXPECT_FALSE(world.alive(old));
    EXPECT_EQ(world.find<Position>(old), nullptr);
    EXPECT_FALSE(world.has<Position>(old));
    EXPECT_FALSE(world.remove<Position>(old));
    EXPECT_FALSE(world.destroy(old));
    EXPECT_FALSE(world.changedSince<Position>(old, 0));
    EXPECT_EQ(world.get<Position>(reused).x, 2);
}

TEST(WorldDeath, NamesTheStaleHandleAndTheComponent) {
    World world;
    const Entity old = world.create();
    world.destroy(old);
    const Entity reused = world.create();
    EXPECT_DEATH(world.add(old, Position{}), "add<Position>.*entity 0v0: the handle is stale.*0v1");
    EXPECT_DEATH(static_cast<void>(world.get<Position>(old)), "get<Position>.*stale");
    EXPECT_DEATH(world.edit<Position>(old).x = 1, "edit<Position>.*stale");
    EXPECT_DEATH(world.set(old, Position{}), "set<Position>.*stale");
    EXPECT_DEATH(static_cast<void>(world.get<Position>(reused)), "entity 0v1: the entity has none");
    EXPECT_DEATH(static_cast<void>(world.get<Position>(Entity{})), "entity none");
}

TEST(WorldDeath, AddsAComponentOnlyOnce) {
    World world;
    const Entity e = world.create();
    world.add(e, Position{});
    EXPECT_DEATH(world.add(e, Position{}), "add<Position>.*has one already");
}

TEST(World, RetiresASlotWhoseGenerationsAreUsedUp) {
    World world;
    const Entity first = world.create();
    Entity last = first;
    for (uint32_t i = 0; i < Entity::kMaxGeneration; ++i) {
        world.destroy(last);
        last = world.create();
        ASSERT_EQ(last.index(), first.index());
        ASSERT_FALSE(world.alive(first)) << "after " << i << " reuses";
    }
    EXPECT_EQ(last.generation(), Entity::kMaxGeneration);
    world.destroy(last);
    const Entity next = world.create();
    EXPECT_NE(next.index(), first.index());
    EXPECT_FALSE(world.alive(first));
    EXPECT_FALSE(world.alive(last));
}

TEST(World, SetReplacesAndEditChangesInPlace) {
    World world;
    const Entity e = world.create();
    world.set(e, Label{"one"});
    world.set(e, Label{"two"});
    EXPECT_EQ(world.get<Label>(e).text, "two");
    world.edit<Label>(e).text += "!";
    world.edit<Label>(e, [](Label& label) { label.text += "?"; });
    EXPECT_EQ(world.get<Label>(e).text, "two!?");
    EXPECT_EQ(world.count<Label>(), 1u);
}

TEST(World, HoldsComponentsThatOnlyMove) {
    World world;
    const Entity a = world.create();
    const Entity b = world.create();
    world.add(a, Owned{std::make_unique<int>(1)});
    world.add(b, Owned{std::make_unique<int>(2)});
    world.remove<Owned>(a);
    EXPECT_EQ(*world.get<Owned>(b).value, 2);
}

TEST(World, KeepsValuesInPlaceWhileOthersAreAdded) {
    World world;
    const Entity first = world.create();
    const Position* before = &world.add(first, Position{7});
    for (uint32_t i = 0; i < 3 * SparseSet::kPageSize; ++i) world.add(world.create(), Position{});
    EXPECT_EQ(world.find<Position>(first), before);
}

TEST(World, SurvivesBeingMoved) {
    World world;
    const Entity e = world.create();
    world.add(e, Position{5});
    int told = 0;
    const Connection connection = world.onChange<Position>([&](World&, Entity) { ++told; });
    World moved = std::move(world);
    moved.edit<Position>(e).x = 6;
    EXPECT_EQ(moved.get<Position>(e).x, 6);
    EXPECT_EQ(told, 1);
}

TEST(World, HoldsOneResourceAType) {
    World world;
    EXPECT_EQ(world.findResource<Label>(), nullptr);
    world.setResource(Label{"a"});
    Label& label = world.resource<Label>();
    world.setResource(Label{"b"});
    EXPECT_EQ(label.text, "b");
    EXPECT_EQ(std::as_const(world).resource<Label>().text, "b");
    EXPECT_EQ(world.findResource<Position>(), nullptr);
}

TEST(WorldDeath, NamesTheMissingResource) {
    World world;
    EXPECT_DEATH(world.resource<Label>().text = "", "resource<Label>");
}

TEST(World, HoldsAMillionEntities) {
    World world;
    constexpr uint32_t kMany = 1'000'000;
    for (uint32_t i = 0; i < kMany; ++i) world.add<Tag>(world.create());
    EXPECT_EQ(world.entityCount(), kMany);
    EXPECT_EQ(world.count<Tag>(), kMany);
}

TEST(World, IsReadFromSeveralThreadsAtOnce) {
    World world;
    for (int i = 0; i < 1000; ++i) world.add(world.create(), Position{i});
    std::array<int, 4> sums{};
    std::vector<std::thread> readers;
    readers.reserve(sums.size());
    for (int& sum : sums)
        readers.emplace_back([&sum, &shared = std::as_const(world)] {
            for (const auto& [e, position] : shared.view<Position>(without<Tag>))
                sum += position.x + int(shared.has<Label>(e)) +
                       int(shared.changedSince<Position>(e, 1));
        });
    for (std::thread& reader : readers) reader.join();
    EXPECT_EQ(sums, (std::array<int, 4>{499500, 499500, 499500, 499500}));
}

TEST(WorldDeath, SaysWhenNoMoreEntitiesFit) {
    World world;
    for (uint32_t i = 0; i < Entity::kMaxEntities; ++i) world.create();
    EXPECT_DEATH(world.create(), "1048575 < 1048575");
}

}  // namespace
}  // namespace lampyris::ecs
