// The measurement of `bench refit`, at a small size.
#include "accel/refit_bench.h"
#include "execute/executor.h"
#include "support/gpu_test.h"
#include "support/snapshot_builder.h"

namespace lampyris::test {
namespace {

using RefitBenchTest = GpuTest;

TEST_F(RefitBenchTest, MeasuresEveryPart) {
    auto executor = need(execute::Executor::create(device()));
    const assets::Mesh mesh = [] {
        assets::Mesh soup = triangleSoup(3000, 0.1f, 1);
        assets::updateBounds(soup);
        return soup;
    }();
    const auto times = need(accel::measureRefit(executor, mesh, 1));
    EXPECT_EQ(times.triangles, 3000u);
    for (const double part : {times.leaves, times.levels, times.cost, times.cpu, times.upload,
                              times.rebuild, times.embree})
        EXPECT_GT(part, 0.0);
    EXPECT_NEAR(times.device, times.leaves + times.levels + times.cost, 0.5 * times.device + 1.0);
    const auto share = need(accel::measureShare(executor, mesh, 3, 1));
    EXPECT_EQ(share.meshes, 3u);
    EXPECT_GT(share.oneOnDevice, 0.0);
    EXPECT_GT(share.oneOnCpu, 0.0);
}

}  // namespace
}  // namespace lampyris::test
