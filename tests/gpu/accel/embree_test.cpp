// The same rays through the shader and through Embree.
#include "accel/embree_rays.h"
#include "accel/ray_bench.h"
#include "gpu/accel/trace_fixture.h"
#include "scene/builtin/builtin.h"
#include "scene/extract.h"

namespace lampyris::test {
namespace {

/// Hits that differ; Embree's triangle test is not watertight, and instances are turned in other
/// roundings.
size_t differences(const std::vector<GpuHit>& onGpu, const std::vector<GpuHit>& onCpu) {
    size_t different = 0;
    for (size_t i = 0; i < onGpu.size(); ++i) {
        const bool missed = onGpu[i].instance == shared::SCENE_NONE;
        const bool same = onGpu[i].instance == onCpu[i].instance &&
                          (missed || onGpu[i].primitive == onCpu[i].primitive);
        different += same ? 0 : 1;
    }
    return different;
}

TEST_F(TraceTest, AgreesWithEmbree) {
    SnapshotBuilder scene;
    const uint32_t material = scene.addMaterial(mattMaterial());
    const uint32_t soup = scene.addMesh(triangleSoup(20000, 0.03f, 21));
    for (uint32_t i = 0; i < 5; ++i) scene.addInstance(soup, material, anyTransform(i, i == 2));
    const auto rays = randomRays(50000, 2.0f, 22);
    const auto onGpu = trace(scene.snapshot, rays);
    std::vector<GpuHit> onCpu(rays.size());
    need(accel::EmbreeRays::create(scene.snapshot)).trace(rays, onCpu);
    EXPECT_LE(differences(onGpu, onCpu), rays.size() / 2000);
}

TEST_F(TraceTest, WalksTreesDeeperThanTheSmallestStack) {
    SnapshotBuilder scene;
    const uint32_t material = scene.addMaterial(mattMaterial());
    const uint32_t soup = scene.addMesh(triangleSoup(20000, 0.05f, 23));
    for (uint32_t i = 0; i < 100; ++i) scene.addInstance(soup, material, anyTransform(i));
    residency::SceneOnGpu onDevice(device());
    accel::AccelOnGpu accel(onDevice);
    const auto rays = randomRays(5000, 3.0f, 24);
    const auto onGpu = traceIn(onDevice, accel, scene.snapshot, rays);
    EXPECT_GT(accel.counts().deepest, 20u);
    std::vector<GpuHit> onCpu(rays.size());
    need(accel::EmbreeRays::create(scene.snapshot)).trace(rays, onCpu);
    EXPECT_LE(differences(onGpu, onCpu), rays.size() / 1000);
}

TEST_F(TraceTest, WalksMoreThanAStorageBufferMayHold) {
    SnapshotBuilder scene;
    scene.addInstance(scene.addMesh(triangleSoup(2'900'000, 0.005f, 25)),
                      scene.addMaterial(mattMaterial()));
    residency::SceneOnGpu onDevice(device());
    accel::AccelOnGpu accel(onDevice);
    const auto rays = randomRays(2000, 1.0f, 26);
    const auto onGpu = traceIn(onDevice, accel, scene.snapshot, rays);
    EXPECT_GT(accel.counts().triangles * 3 * sizeof(glm::vec4), uint64_t{128} << 20);
    std::vector<GpuHit> onCpu(rays.size());
    need(accel::EmbreeRays::create(scene.snapshot)).trace(rays, onCpu);
    EXPECT_LE(differences(onGpu, onCpu), 2u);
}

TEST_F(TraceTest, IsMeasuredBesideEmbree) {
    auto executor = need(execute::Executor::create(device()));
    const auto world = need(scene::builtinScene("cornell"));
    const auto rates = need(
        accel::measureRays(executor, scene::extract(world, {}, 0), {.paths = 2000, .repeats = 1}));
    EXPECT_GT(rates.rays, 4000u);
    EXPECT_LE(rates.different, rates.rays / 2000);
    EXPECT_GT(rates.gpuMraysPerSecond, 0.0);
    EXPECT_GT(rates.embreeMraysPerSecond, 0.0);
}

}  // namespace
}  // namespace lampyris::test
