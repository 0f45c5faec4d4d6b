#include "photons/prefix_sum.h"

#include <gtest/gtest.h>

#include "execute/executor.h"
#include "gpu/staging.h"
#include "support/gpu_test.h"

namespace lampyris::photons {
namespace {

class PrefixSum : public test::GpuTest {};

TEST_F(PrefixSum, EqualsARunningSumAtEverySize) {
    auto executor = test::need(execute::Executor::create(device()));
    for (const uint32_t count :
         {1u, 2u, 63u, 64u, 65u, 1023u, 1024u, 1025u, 2048u, 70001u, 300000u}) {
        std::vector<uint32_t> counts(count);
        for (uint32_t i = 0; i < count; ++i) counts[i] = (i * 2654435761u >> 24) % 7;
        auto buffer = test::need(gpu::Buffer::create(
            device(),
            {.bytes = uint64_t{count} * 4, .memory = gpu::MemoryUse::Device, .name = "counts"}));
        test::need(gpu::upload(device(), buffer, std::span<const uint32_t>(counts)));
        graph::Frame frame;
        const auto in =
            frame.importBuffer("counts", {buffer.bytes()}, {&buffer}, graph::Access::StorageRead);
        const auto sums = addPrefixSum(frame, "test", in, count);
        frame.output(sums);
        execute::RunOptions options;
        options.readBackBuffers = {sums};
        const auto out =
            test::valuesOf<uint32_t>(test::need(executor.run(frame, options)).buffers[0]);
        ASSERT_EQ(out.size(), count + 1);
        uint32_t running = 0;
        for (uint32_t i = 0; i < count; ++i) {
            ASSERT_EQ(out[i], running) << "element " << i << " of " << count;
            running += counts[i];
        }
        ASSERT_EQ(out[count], running) << count;
    }
}

}  // namespace
}  // namespace lampyris::photons
