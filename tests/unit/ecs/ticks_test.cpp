#include <gtest/gtest.h>

#include "ecs/world.h"

namespace lampyris::ecs {
namespace {

struct Heat {
    int value = 0;
};
struct Other {};

class Ticks : public testing::Test {
 protected:
    Entity make() {
        const Entity e = world.create();
        world.add(e, Heat{});
        return e;
    }
    World world;
};

TEST_F(Ticks, EverythingIsAChangeSinceZero) {
    const Entity a = make();
    const Entity b = make();
    EXPECT_EQ(world.changedSince<Heat>(0), (std::vector<Entity>{a, b}));
}

TEST_F(Ticks, ChangesAreThoseAfterTheTickThatEnded) {
    const Entity a = make();
    const Entity b = make();
    const Tick since = world.advance();
    EXPECT_TRUE(world.changedSince<Heat>(since).empty());
    world.edit<Heat>(b).value = 1;
    EXPECT_EQ(world.changedSince<Heat>(since), std::vector<Entity>{b});
    EXPECT_FALSE(world.changedSince<Heat>(a, since));
    EXPECT_TRUE(world.changedSince<Heat>(b, since));

    const Tick later = world.advance();
    EXPECT_FALSE(world.changedSince<Heat>(b, later));
    EXPECT_TRUE(world.changedSince<Heat>(b, since)) << "an older reader still sees it";
}

TEST_F(Ticks, ReadingIsNoChange) {
    const Entity a = make();
    const Tick since = world.advance();
    EXPECT_EQ(world.get<Heat>(a).value, 0);
    for (const auto& [e, heat] : world.view<Heat>()) EXPECT_EQ(heat.value, 0);
    world.add<Other>(a);
    EXPECT_FALSE(world.changedSince<Heat>(a, since));
}

TEST_F(Ticks, ATickMovesWithItsValue) {
    const Entity a = make();
    const Entity b = make();
    const Entity c = make();
    const Tick since = world.advance();
    world.edit<Heat>(c).value = 1;
    world.remove<Heat>(a);  // c takes a's place
    EXPECT_EQ(world.changedSince<Heat>(since), std::vector<Entity>{c});
    world.destroy(c);
    EXPECT_TRUE(world.changedSince<Heat>(since).empty());
    EXPECT_TRUE(world.changedSince<Heat>(b, 0));
}

TEST_F(Ticks, FindsOneChangeAmongManyPages) {
    std::vector<Entity> all;
    for (uint32_t i = 0; i < 3 * SparseSet::kPageSize + 5; ++i) all.push_back(make());
    const Tick since = world.advance();
    for (const size_t at : {size_t{0}, size_t{SparseSet::kPageSize}, all.size() - 1})
        world.edit<Heat>(all[at]).value = 1;
    EXPECT_EQ(world.changedSince<Heat>(since),
              (std::vector<Entity>{all[0], all[SparseSet::kPageSize], all.back()}));
}

TEST_F(Ticks, RemembersRemovalsUntilTold) {
    const Entity a = make();
    const Entity b = make();
    const Entity c = make();
    world.remove<Heat>(a);
    const Tick first = world.advance();
    world.destroy(b);
    EXPECT_EQ(world.removedSince<Heat>(0), (std::vector<Entity>{a, b}));
    EXPECT_EQ(world.removedSince<Heat>(first), std::vector<Entity>{b});
    world.forgetRemovals(first);
    EXPECT_EQ(world.removedSince<Heat>(0), std::vector<Entity>{b});
    EXPECT_EQ(world.removedSince<Other>(0), std::vector<Entity>{});
    EXPECT_TRUE(world.has<Heat>(c));
}

}  // namespace
}  // namespace lampyris::ecs
