// AccelOnGpu from snapshot to snapshot.
#include "gpu/accel/trace_fixture.h"

namespace lampyris::test {
namespace {

TEST_F(TraceTest, FollowsWhatMovesAppearsAndGoes) {
    SnapshotBuilder scene;
    const uint32_t material = scene.addMaterial(mattMaterial());
    const uint32_t first = scene.addMesh(triangleSoup(50, 0.5f, 31));
    scene.addInstance(first, material);
    residency::SceneOnGpu onGpu(device());
    accel::AccelOnGpu accel(onGpu);
    const auto rays = randomRays(1000, 2.5f, 32);
    const auto check = [&](uint32_t builds) {
        const auto hits = traceIn(onGpu, accel, scene.snapshot, rays);
        EXPECT_GT(expectExact(scene.snapshot, rays, hits), 50u);
        EXPECT_EQ(accel.counts().rebuilds, builds);
    };
    check(1);
    check(0);
    scene.moveInstance(0, anyTransform(33));
    check(0);
    const uint32_t second = scene.addMesh(triangleSoup(3000, 0.1f, 34));
    for (uint32_t i = 0; i < 40; ++i)
        scene.addInstance(i % 2 == 0 ? first : second, material, anyTransform(i));
    check(1);
    scene.replaceMesh(first, triangleSoup(70, 0.4f, 35));
    check(1);
    scene.snapshot.instances.resize(3);
    scene.snapshot.meshes.resize(2);
    scene.moveInstance(1, anyTransform(36, true));
    check(0);
    EXPECT_EQ(accel.counts().triangles, 3070u);
}

TEST_F(TraceTest, NamesTheLimitThatAScenePasses) {
    const uint64_t texels = device().limits().core.maxTexelBufferElements;
    residency::ResidentBuffer buffer(device(), "bvh triangles", sizeof(glm::vec4));
    const std::string message = errorOf(buffer.reserve((texels + 1) * sizeof(glm::vec4)));
    EXPECT_NE(message.find("bvh triangles"), std::string::npos) << message;
    EXPECT_TRUE(message.find("maxTexelBufferElements") != std::string::npos ||
                message.find("maxBufferSize") != std::string::npos)
        << message;
}

}  // namespace
}  // namespace lampyris::test
