#include "reference/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace lampyris::reference {
namespace {

TEST(ShareOut, DoesEachPieceOnce) {
    for (const uint32_t threads : {0u, 1u, 3u, 50u})
        for (const uint32_t count : {0u, 1u, 2u, 1000u}) {
            std::vector<std::atomic<int>> visits(count);
            shareOut(count, threads, [&](uint32_t i) { ++visits[i]; });
            for (const auto& visit : visits) ASSERT_EQ(visit, 1);
        }
}

TEST(ShareOut, PassesOnWhatACallThrows) {
    std::atomic<uint32_t> calls{0};
    const auto work = [&](uint32_t i) {
        ++calls;
        if (i == 5) throw std::runtime_error("five");
    };
    EXPECT_THROW(shareOut(1u << 30u, 4, work), std::runtime_error);
    EXPECT_LT(calls, 1u << 30u) << "the rest is left";
}

}  // namespace
}  // namespace lampyris::reference
