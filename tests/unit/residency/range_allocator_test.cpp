#include "residency/range_allocator.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace lampyris::residency {
namespace {

TEST(RangeAllocator, FillsGapsFirst) {
    RangeAllocator ranges;
    EXPECT_EQ(ranges.take(10), 0u);
    EXPECT_EQ(ranges.take(20), 10u);
    EXPECT_EQ(ranges.take(5), 30u);
    ranges.give(10, 20);
    EXPECT_EQ(ranges.take(25), 35u);
    EXPECT_EQ(ranges.take(8), 10u);
    EXPECT_EQ(ranges.take(12), 18u);
    EXPECT_EQ(ranges.capacity(), 60u);
    EXPECT_EQ(ranges.used(), 60u);
}

TEST(RangeAllocator, JoinsNeighboursAndGrowsFromTheLastGap) {
    RangeAllocator ranges;
    for (int i = 0; i < 3; ++i) static_cast<void>(ranges.take(10));
    ranges.give(0, 10);
    ranges.give(20, 10);
    ranges.give(10, 10);
    EXPECT_EQ(ranges.used(), 0u);
    EXPECT_EQ(ranges.take(40), 0u);
    EXPECT_EQ(ranges.capacity(), 40u);
}

TEST(RangeAllocator, NeverHandsOutAnElementTwice) {
    RangeAllocator ranges;
    std::mt19937 random(1);
    std::vector<bool> taken(100000, false);
    std::vector<std::pair<uint64_t, uint64_t>> held;
    for (int i = 0; i < 3000; ++i) {
        if (random() % 3 == 0 && !held.empty()) {
            const size_t which = random() % held.size();
            for (uint64_t k = 0; k < held[which].second; ++k) taken[held[which].first + k] = false;
            ranges.give(held[which].first, held[which].second);
            held.erase(held.begin() + static_cast<std::ptrdiff_t>(which));
        } else {
            const uint64_t length = 1 + random() % 20, first = ranges.take(length);
            for (uint64_t k = 0; k < length; ++k) {
                ASSERT_FALSE(taken[first + k]);
                taken[first + k] = true;
            }
            held.emplace_back(first, length);
        }
    }
    EXPECT_LE(ranges.capacity(), 3 * ranges.used());
}

}  // namespace
}  // namespace lampyris::residency
