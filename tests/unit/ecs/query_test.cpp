#include "ecs/query.h"

#include <gtest/gtest.h>

#include "ecs/commands.h"

namespace lampyris::ecs {
namespace {

struct A {
    int value = 0;
};
struct B {
    int value = 0;
};
struct C {};
struct Never {};

class ViewTest : public testing::Test {
 protected:
    ViewTest() {
        for (int i = 0; i < 12; ++i) {
            const Entity e = world.create();
            world.add(e, A{i});
            if (i % 2 == 0) world.add(e, B{10 * i});
            if (i % 3 == 0) world.add<C>(e);
        }
    }
    World world;
};

TEST_F(ViewTest, VisitsWhatHasAllAndNoneInDenseOrder) {
    std::vector<int> seen;
    for (const auto& [e, a, b] : world.view<A, B>(without<C>)) {
        EXPECT_EQ(b.value, 10 * a.value);
        EXPECT_EQ(&a, world.find<A>(e));
        seen.push_back(a.value);
    }
    EXPECT_EQ(seen, (std::vector<int>{2, 4, 8, 10}));
}

TEST_F(ViewTest, EachSeesTheSameAsTheLoop) {
    std::vector<int> seen;
    world.view<A, B>(without<C>).each([&](Entity, const A& a, const B&) {
        seen.push_back(a.value);
    });
    EXPECT_EQ(seen, (std::vector<int>{2, 4, 8, 10}));
    EXPECT_EQ((world.view<A, B>(without<C>).count()), 4u);
    EXPECT_EQ((world.view<B, A, C>().count()), 2u);
}

TEST_F(ViewTest, IsEmptyWithAComponentThatNobodyEverHad) {
    EXPECT_EQ((world.view<A, Never>().count()), 0u);
    EXPECT_EQ((world.view<Never, A>().count()), 0u);
    EXPECT_EQ(world.view<A>(without<Never>).count(), 12u);
    EXPECT_EQ(World().view<A>().count(), 0u);
}

TEST_F(ViewTest, LetsValuesChangeWhileItIsWalked) {
    const Tick since = world.advance();
    for (const auto& [e, a] : world.view<A>()) world.edit<A>(e).value = a.value + 100;
    EXPECT_EQ(world.changedSince<A>(since).size(), 12u);
    EXPECT_EQ(world.get<A>(world.entities()[3]).value, 103);
}

TEST_F(ViewTest, LetsComponentsOfOtherKindsComeAndGo) {
    for (const auto& [e, a] : world.view<A>()) world.set(e, B{a.value});
    EXPECT_EQ(world.count<B>(), 12u);
}

TEST_F(ViewTest, AllowsOneRemovalBeforeLeavingTheLoop) {
    for (const auto& [e, a] : world.view<A>()) {
        if (a.value != 5) continue;
        world.destroy(e);
        break;
    }
    EXPECT_EQ(world.count<A>(), 11u);
}

using ViewDeath = ViewTest;

TEST_F(ViewDeath, CatchesARemovalInTheLoop) {
    EXPECT_DEATH(
        {
            for (const auto& [e, a] : world.view<A>()) world.remove<A>(e);
        },
        "structureVersion");
    EXPECT_DEATH(world.view<A>().each([&](Entity e, const A&) { world.destroy(e); }),
                 "structureVersion");
}

TEST_F(ViewDeath, CatchesAnAdditionInTheLoop) {
    EXPECT_DEATH(
        {
            for (const auto& [e, a] : world.view<A>()) world.add(world.create(), A{a});
        },
        "structureVersion");
    EXPECT_DEATH(
        {
            for (const auto& [e, a] : world.view<A>(without<C>)) world.add<C>(e);
        },
        "structureVersion");
}

TEST_F(ViewTest, CommandsPutChangesOff) {
    Commands commands;
    for (const auto& [e, a] : world.view<A>()) {
        if (a.value >= 6) commands.destroy(e);
        if (a.value < 2) commands.add(commands.create(), A{1000});
    }
    EXPECT_EQ(world.count<A>(), 12u);
    EXPECT_EQ(commands.apply(world).size(), 2u);
    EXPECT_EQ(world.count<A>(), 8u);
}

}  // namespace
}  // namespace lampyris::ecs
