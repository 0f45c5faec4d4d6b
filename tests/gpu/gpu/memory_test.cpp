#include "gpu/memory.h"

#include <algorithm>
#include <random>

#include "gpu/buffer.h"
#include "support/gpu_test.h"

namespace lampyris {
namespace {

class MemoryTest : public test::GpuTest {
 protected:
    VkMemoryRequirements needs(uint64_t bytes, uint64_t alignment = 256) {
        VkMemoryRequirements any = gpu::bufferMemoryRequirements(device(), 16);
        any.size = bytes;
        any.alignment = alignment;
        return any;
    }
    gpu::Allocation take(uint64_t bytes, uint64_t alignment = 256) {
        return test::need(device().memory().allocate(needs(bytes, alignment),
                                                     gpu::MemoryUse::Upload, true, "test"));
    }
};

TEST_F(MemoryTest, GivesBackWhatItTook) {
    const uint64_t before = device().memory().bytes();
    {
        const auto small = take(1000);
        const auto large = take(uint64_t{40} << 20);
        EXPECT_GE(device().memory().bytes(), before + (uint64_t{40} << 20));
        EXPECT_NE(small.memory(), large.memory());
    }
    EXPECT_EQ(device().memory().bytes(), before);
}

TEST_F(MemoryTest, PiecesNeverOverlap) {
    std::mt19937 random{1};
    std::vector<gpu::Allocation> pieces;
    for (int round = 0; round < 400; ++round) {
        if (!pieces.empty() && random() % 3 == 0) {
            std::swap(pieces[random() % pieces.size()], pieces.back());
            pieces.pop_back();
        } else {
            const uint64_t alignment = uint64_t{1} << (4 + random() % 8);
            pieces.push_back(take(1 + random() % 200000, alignment));
            EXPECT_EQ(pieces.back().offset() % alignment, 0u);
        }
    }
    for (size_t a = 0; a < pieces.size(); ++a)
        for (size_t b = 0; b < a; ++b) {
            const bool apart = pieces[a].memory() != pieces[b].memory() ||
                               pieces[a].offset() >= pieces[b].offset() + pieces[b].bytes() ||
                               pieces[b].offset() >= pieces[a].offset() + pieces[a].bytes();
            EXPECT_TRUE(apart);
        }
}

TEST_F(MemoryTest, FillsTheGapsThatArise) {
    const auto first = take(4096);
    auto middle = take(4096);
    const auto last = take(4096);
    const uint64_t gap = middle.offset();
    middle = {};
    EXPECT_EQ(take(4096).offset(), gap);
}

TEST_F(MemoryTest, NamesTheLimitThatAnAllocationExceeds) {
    const uint64_t most = device().limits().maxMemoryAllocationSize;
    const auto refused =
        device().memory().allocate(needs(most + 1), gpu::MemoryUse::Device, true, "huge");
    EXPECT_NE(test::errorOf(refused).find("huge"), std::string::npos);
    EXPECT_NE(test::errorOf(refused).find("maxMemoryAllocationSize"), std::string::npos);
}

}  // namespace
}  // namespace lampyris
