#include "gpu/staging.h"

#include <numeric>

#include "support/gpu_test.h"

namespace lampyris {
namespace {

using test::need;

class StagingTest : public test::GpuTest {
 protected:
    static std::vector<uint32_t> countTo(size_t count) {
        std::vector<uint32_t> values(count);
        std::iota(values.begin(), values.end(), 1u);
        return values;
    }
};

TEST_F(StagingTest, BytesComeBackAsTheyWent) {
    const auto buffer = need(gpu::Buffer::create(device(), {.bytes = 4096, .name = "bytes"}));
    auto staging = need(gpu::Staging::create(device()));
    const auto values = countTo(100);
    need(staging.write(buffer, 64, std::as_bytes(std::span{values})));
    const auto back = need(staging.read(buffer, 64, 400));
    EXPECT_EQ(test::valuesOf<uint32_t>(back), values);
}

TEST_F(StagingTest, WritesMoreThanItsOwnMemory) {
    const auto values = countTo((size_t{70} << 20) / 4);
    const auto buffer =
        need(gpu::Buffer::create(device(), {.bytes = values.size() * 4, .name = "large"}));
    need(gpu::upload(device(), buffer, std::span<const uint32_t>{values}));
    auto staging = need(gpu::Staging::create(device()));
    const auto back = need(staging.read(buffer, 0, values.size() * 4));
    EXPECT_TRUE(test::valuesOf<uint32_t>(back) == values);
}

TEST_F(StagingTest, HostVisibleBuffersAreMapped) {
    const auto upload = need(gpu::Buffer::create(
        device(), {.bytes = 64, .memory = gpu::MemoryUse::Upload, .name = "mapped"}));
    EXPECT_GE(upload.mapped().size(), 64u);
}

}  // namespace
}  // namespace lampyris
