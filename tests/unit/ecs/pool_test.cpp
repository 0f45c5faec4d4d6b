#include "ecs/pool.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "ecs/world.h"

namespace lampyris::ecs {
namespace {

constexpr uint32_t kPage = SparseSet::kPageSize;

Entity entityAt(uint32_t index, uint32_t generation = 0) {
    return {(generation << Entity::kIndexBits) | index};
}

TEST(Pool, FindsValuesOnBothSidesOfEachPageBoundary) {
    for (const uint32_t count : {kPage - 1, kPage, kPage + 1, 2 * kPage, 2 * kPage + 1}) {
        Pool<uint32_t> pool;
        for (uint32_t i = 0; i < count; ++i) pool.insert(entityAt(i), i, 1);
        ASSERT_EQ(pool.size(), count);
        for (const uint32_t i : {0u, kPage - 2, count - 1}) ASSERT_EQ(*pool.find(entityAt(i)), i);
        EXPECT_EQ(pool.find(entityAt(count)), nullptr);
    }
}

TEST(Pool, ShrinksAndGrowsAcrossAPageBoundary) {
    Pool<uint32_t> pool;
    for (uint32_t i = 0; i < kPage + 1; ++i) pool.insert(entityAt(i), i, 1);
    for (int round = 0; round < 3; ++round) {
        EXPECT_EQ(pool.take(entityAt(kPage), 1), kPage);
        EXPECT_EQ(pool.take(entityAt(kPage - 1), 1), kPage - 1);
        pool.insert(entityAt(kPage - 1), kPage - 1, 1);
        pool.insert(entityAt(kPage), kPage, 1);
        EXPECT_EQ(*pool.find(entityAt(kPage)), kPage);
        EXPECT_EQ(*pool.find(entityAt(kPage - 1)), kPage - 1);
    }
}

TEST(Pool, MovesTheLastIntoTheHoleOfARemoval) {
    Pool<int> pool;
    for (int i = 0; i < 4; ++i) pool.insert(entityAt(static_cast<uint32_t>(i)), i, 1);
    EXPECT_EQ(pool.take(entityAt(1), 2), 1);
    const std::vector<Entity> order(pool.entities().begin(), pool.entities().end());
    EXPECT_EQ(order, (std::vector<Entity>{entityAt(0), entityAt(3), entityAt(2)}));
    EXPECT_EQ(*pool.find(entityAt(3)), 3);
}

TEST(Pool, TellsGenerationsOfOneSlotApart) {
    Pool<int> pool;
    pool.insert(entityAt(9, 1), 1, 1);
    EXPECT_EQ(pool.find(entityAt(9, 0)), nullptr);
    EXPECT_EQ(pool.find(entityAt(9, 2)), nullptr);
    EXPECT_EQ(*pool.find(entityAt(9, 1)), 1);
}

TEST(Pool, HoldsTheHighestIndex) {
    Pool<int> pool;
    pool.insert(entityAt(Entity::kMaxEntities - 1, Entity::kMaxGeneration), 3, 1);
    EXPECT_EQ(*pool.find(entityAt(Entity::kMaxEntities - 1, Entity::kMaxGeneration)), 3);
    EXPECT_EQ(pool.find(Entity{}), nullptr);
}

struct Number {
    int value = 0;
};

// The world against a std::map that cannot be wrong, over random operations of every kind.
class RandomOperations : public testing::TestWithParam<unsigned> {};

TEST_P(RandomOperations, AgreeWithAMap) {
    std::mt19937 random(GetParam());
    const auto below = [&](size_t n) {
        return std::uniform_int_distribution<size_t>(0, n - 1)(random);
    };
    World world;
    std::map<Entity, std::map<char, int>> model;  // living entities and their components
    std::vector<Entity> dead;
    const auto pick = [&] {
        return std::next(model.begin(), static_cast<std::ptrdiff_t>(below(model.size())));
    };

    for (int step = 0; step < 20000; ++step) {
        const size_t action = model.empty() ? 0 : below(10);
        if (action <= 1) {
            ASSERT_TRUE(model.try_emplace(world.create()).second)
                << "a living handle was given twice";
        } else if (action == 2) {
            const auto victim = pick();
            ASSERT_TRUE(world.destroy(victim->first));
            dead.push_back(victim->first);
            model.erase(victim);
        } else if (action <= 5) {
            const auto at = pick();
            at->second['n'] = step;
            world.set(at->first, Number{step});
        } else if (action <= 7) {
            const auto at = pick();
            at->second['i'] = step;
            world.set(at->first, step);
        } else if (action == 8) {
            const auto at = pick();
            ASSERT_EQ(world.remove<Number>(at->first), at->second.erase('n') == 1);
        } else {
            const auto at = pick();
            ASSERT_EQ(world.remove<int>(at->first), at->second.erase('i') == 1);
        }
    }

    ASSERT_EQ(world.entityCount(), model.size());
    size_t both = 0;
    for (const auto& [e, components] : model) {
        ASSERT_TRUE(world.alive(e));
        const Number* number = world.find<Number>(e);
        ASSERT_EQ(number != nullptr, components.contains('n'));
        ASSERT_TRUE(number == nullptr || number->value == components.at('n'));
        ASSERT_EQ(world.has<int>(e), components.contains('i'));
        ASSERT_TRUE(!world.has<int>(e) || world.get<int>(e) == components.at('i'));
        if (components.size() == 2) ++both;
    }
    EXPECT_EQ((world.view<Number, int>().count()), both);
    EXPECT_EQ(world.view<Number>(without<int>).count(), world.count<Number>() - both);
    for (const Entity e : dead) {
        ASSERT_FALSE(world.alive(e));
        ASSERT_EQ(world.find<Number>(e), nullptr);
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomOperations, testing::Values(1u, 2u, 3u, 4u, 5u));

}  // namespace
}  // namespace lampyris::ecs
