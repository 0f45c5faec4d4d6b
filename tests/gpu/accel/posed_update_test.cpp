// Deforming instances through AccelOnGpu, from snapshot to snapshot, on either path.
#include "accel/tree.h"
#include "gpu/accel/posed_builder.h"
#include "gpu/accel/trace_fixture.h"
#include "shared/refit.h"

namespace lampyris::test {
namespace {

using accel::RefitPath;

class PosedTest : public TraceTest, public ::testing::WithParamInterface<RefitPath> {
 protected:
    void SetUp() override {
        TraceTest::SetUp();
        if (IsSkipped()) return;
        onGpu.emplace(device());
        accel.emplace(*onGpu, accel::AccelSettings{GetParam(), {}});
    }
    void expectHits(const PosedBuilder& scene, const std::vector<GpuRay>& rays, size_t least) {
        const auto hits = traceIn(*onGpu, *accel, scene.snapshot, rays);
        EXPECT_GT(expectExact(scene.baked(), rays, hits), least);
    }
    std::optional<residency::SceneOnGpu> onGpu;
    std::optional<accel::AccelOnGpu> accel;
};

INSTANTIATE_TEST_SUITE_P(Paths, PosedTest, ::testing::Values(RefitPath::Cpu, RefitPath::Device),
                         [](const auto& path) {
                             return path.param == RefitPath::Cpu ? "Cpu" : "Device";
                         });

TEST_P(PosedTest, FindsWhatDeformedInTheVeryFrame) {
    PosedBuilder scene;
    const uint32_t material = scene.addMaterial(mattMaterial());
    const uint32_t mesh = scene.addMesh(morphingSoup(300, 1));
    for (uint32_t i = 0; i < 4; ++i) scene.addInstance(mesh, material, anyTransform(i, i == 2));
    scene.pose(1, 0.2f, 0.0f);
    scene.pose(2, 0.0f, 0.0f);
    const auto rays = randomRays(1000, 2.0f, 2);
    expectHits(scene, rays, 100);
    EXPECT_EQ(accel->counts().blas, 3u) << "two at rest share one, each posed has its own";
    EXPECT_EQ(accel->counts().rebuilds, 3u);
    for (uint32_t frame = 1; frame <= 5; ++frame) {
        scene.pose(1, 0.3f * static_cast<float>(frame), -0.2f);
        if (frame % 2 == 0) scene.pose(2, frame == 4 ? -8.0f : 0.1f, 2.0f);
        expectHits(scene, rays, 50);
        EXPECT_EQ(accel->counts().refits, frame % 2 == 0 ? 2u : 1u);
        EXPECT_EQ(accel->counts().rebuilds, 0u);
    }
    scene.snapshot.instances[1].pose = nullptr;
    scene.snapshot.instances[1].poseVersion = 0;
    scene.moveInstance(1, anyTransform(9));
    expectHits(scene, rays, 50);
    EXPECT_EQ(accel->counts().blas, 2u);
}

TEST_P(PosedTest, LoadsWhatIsTooLargeToGoUpWithItsFrame) {
    PosedBuilder scene;
    scene.addInstance(scene.addMesh(morphingSoup(100'000, 4)), scene.addMaterial(mattMaterial()));
    scene.pose(0, 0.1f, 0.0f);
    expectHits(scene, randomRays(300, 2.0f, 2), 50);

    accel.emplace(*onGpu, accel::AccelSettings{GetParam(), {}});
    need(accel->update(scene.snapshot));
    graph::Frame frame;
    static_cast<void>(accel->import(frame, onGpu->import(frame)));
    for (const auto& node : frame.nodes()) EXPECT_NE(node.name, "upload bvh triangles");
}

TEST_P(PosedTest, TouchesOneTreeOfManyAndNoneForRigidMotion) {
    PosedBuilder scene;
    const uint32_t material = scene.addMaterial(mattMaterial());
    const uint32_t mesh = scene.addMesh(morphingSoup(50, 3));
    for (uint32_t i = 0; i < 100; ++i) {
        scene.addInstance(mesh, material, anyTransform(i));
        scene.pose(i, 0.1f, 0.01f * static_cast<float>(i));
    }
    need(onGpu->update(scene.snapshot));
    need(accel->update(scene.snapshot));
    const auto nodesOf = [&] {
        graph::Frame frame;
        const auto handles = onGpu->import(frame);
        static_cast<void>(accel->import(frame, handles));
        std::vector<graph::Node> refits;
        for (const auto& node : frame.nodes())
            if (node.name.starts_with("refit") || node.name == "tlas_upload" ||
                node.name == "upload bvh triangles")
                refits.push_back(node);
        return refits;
    };
    const auto first = nodesOf();
    ASSERT_EQ(first.size(), 2u) << "no refit of what was just built";
    EXPECT_EQ(first[0].name, "tlas_upload");
    EXPECT_EQ(first[1].name, "upload bvh triangles");
    EXPECT_EQ(first[1].copies.size(), 100u);

    scene.moveInstance(7, anyTransform(200));
    need(onGpu->update(scene.snapshot));
    need(accel->update(scene.snapshot));
    EXPECT_EQ(accel->counts().refits, 0u);
    const auto rigid = nodesOf();
    ASSERT_EQ(rigid.size(), 1u);
    EXPECT_EQ(rigid[0].name, "tlas_upload");
    EXPECT_EQ(rigid[0].copies.size(), 1u);

    scene.pose(42, 0.7f, 0.7f);
    need(onGpu->update(scene.snapshot));
    need(accel->update(scene.snapshot));
    EXPECT_EQ(accel->counts().refits, 1u);
    for (const auto& node : nodesOf()) {
        EXPECT_LE(node.copies.size(), node.name == "tlas_upload" ? 2u : 1u) << node.name;
        if (node.kind != graph::NodeKind::Compute) continue;
        ASSERT_EQ(node.uniforms.size(), 1u);
        EXPECT_EQ(node.uniforms[0].bytes.size(), sizeof(shared::GpuRefitJob)) << node.name;
    }
    need(onGpu->update(scene.snapshot));
    need(accel->update(scene.snapshot));
    EXPECT_TRUE(nodesOf().empty()) << "nothing changed";
}

TEST_P(PosedTest, RebuildsWhatGrewBadAFixedNumberOfFramesLater) {
    std::vector<std::vector<std::byte>> runs;
    for (int run = 0; run < 2; ++run) {
        residency::SceneOnGpu own(device());
        accel::AccelOnGpu tree(own, {GetParam(), {}});
        auto executor = need(execute::Executor::create(device()));
        PosedBuilder scene;
        scene.addInstance(scene.addMesh(morphingSoup(2000, 5)), scene.addMaterial(mattMaterial()));
        scene.pose(0, 0.0f, 0.0f);
        std::vector<uint32_t> landed;
        for (uint32_t i = 0; i < 2 * accel::kRebuildFrames; ++i) {
            if (i == 1) scene.pose(0, 3.0f, 1.0f);
            if (i == 4) scene.pose(0, 3.0f, 1.1f);
            need(own.update(scene.snapshot));
            need(tree.update(scene.snapshot));
            if (tree.counts().rebuilds > 0) landed.push_back(i);
            graph::Frame frame;
            const auto handles = own.import(frame);
            const auto bvh = tree.import(frame, handles);
            execute::RunOptions options;
            if (bvh.nodes.version > 0) options.readBackBuffers.push_back(bvh.nodes);
            if (bvh.quality.valid()) options.readBackBuffers.push_back(bvh.quality);
            for (const auto buffer : options.readBackBuffers) frame.output(buffer);
            const auto done = need(executor.run(frame, options));
            if (bvh.quality.valid()) tree.learn(done.buffers[1]);
            runs.push_back(done.buffers.empty() ? std::vector<std::byte>{} : done.buffers[0]);
            // The tree stands first; 2000 triangles have more nodes than that. Behind it is room.
            if (!runs.back().empty()) runs.back().resize(600 * sizeof(accel::Node));
            if (i == 1) {
                EXPECT_GT(tree.counts().sahRatioMax, 1.5);
            }
        }
        // The CPU knows the cost in the frame itself; the device's is read after the frame.
        const uint32_t asked = GetParam() == RefitPath::Cpu ? 1 : 2;
        EXPECT_EQ(landed, (std::vector<uint32_t>{0, asked + accel::kRebuildFrames}));
        EXPECT_LT(tree.counts().sahRatioMax, 1.2);
        const auto rays = randomRays(500, 3.0f, 6);
        EXPECT_GT(expectExact(scene.baked(), rays, traceIn(own, tree, scene.snapshot, rays)), 50u);
    }
    const size_t frames = runs.size() / 2;
    for (size_t i = 0; i < frames; ++i) EXPECT_TRUE(runs[i] == runs[frames + i]) << "frame " << i;
}

}  // namespace
}  // namespace lampyris::test
