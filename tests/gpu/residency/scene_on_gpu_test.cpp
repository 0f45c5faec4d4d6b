// What of a scene goes over to the device, and what arrives there.
#include "residency/scene_on_gpu.h"
#include "residency/pack_scene.h"

#include "execute/executor.h"
#include "residency/resident_buffer.h"
#include "support/gpu_test.h"
#include "support/snapshot_builder.h"

namespace lampyris::test {
namespace {

using residency::UploadCounts;

class ResidencyTest : public GpuTest {
 protected:
    ResidencyTest() {
        if (sharedDevice().ok()) onGpu.emplace(device());
        builder.addMaterial(mattMaterial());
        builder.addInstance(builder.addMesh(unitSquare()), 0);
        builder.addInstance(builder.addMesh(triangleSoup(10, 1.0f, 1)), 0, anyTransform(2));
        builder.addLight({.entity = ecs::Entity{9}, .positionWorld = glm::vec3(1, 2, 3)});
    }

    /// One frame: update, import, run; the contents of a buffer chosen from the handles.
    template <typename T, typename Choose>
    std::vector<T> contents(const Choose& choose) {
        static execute::Executor executor = need(execute::Executor::create(device()));
        need(onGpu->update(builder.snapshot));
        graph::Frame frame;
        const auto handles = residency::importScene(frame, *onGpu);
        execute::RunOptions options;
        const graph::Buffer source = choose(handles);
        const uint64_t bytes = frame.desc(source).bytes;
        const graph::Buffer copy = frame.buffer("copy", {bytes});
        options.readBackBuffers = {frame.transfer("copy").copy(source, 0, copy, 0, bytes)};
        frame.output(options.readBackBuffers[0]);
        return valuesOf<T>(need(executor.run(frame, options)).buffers[0]);
    }
    std::vector<shared::GpuInstance> instances() {
        return contents<shared::GpuInstance>([](const auto& h) { return h.instances; });
    }

    SnapshotBuilder builder;
    std::optional<residency::SceneOnGpu> onGpu;
};

TEST_F(ResidencyTest, SendsEverythingOnceAndThenNothing) {
    need(onGpu->update(builder.snapshot));
    const UploadCounts first = onGpu->lastUpload();
    // 4 + 30 vertices of position and normal, 6 + 30 indices, and texture coordinates for the
    // square alone.
    EXPECT_EQ(first.geometryBytes, 34u * 28u + 36u * 4u + 4u * 16u);
    EXPECT_EQ(first.instanceBytes, 2 * sizeof(shared::GpuInstance));
    EXPECT_EQ(first.materialBytes, sizeof(shared::GpuMaterial));
    EXPECT_EQ(first.lightBytes, sizeof(shared::GpuLight));
    EXPECT_EQ(first.textureBytes, 0u);
    need(onGpu->update(builder.snapshot));
    EXPECT_EQ(onGpu->lastUpload().total(), 0u);
}

TEST_F(ResidencyTest, SendsOnlyWhatChanged) {
    need(onGpu->update(builder.snapshot));
    builder.moveInstance(1, anyTransform(3));
    need(onGpu->update(builder.snapshot));
    EXPECT_EQ(onGpu->lastUpload().total(), sizeof(shared::GpuInstance));
    EXPECT_EQ(onGpu->lastUpload().instanceBytes, sizeof(shared::GpuInstance));
    builder.addLight({.entity = ecs::Entity{10}});
    need(onGpu->update(builder.snapshot));
    EXPECT_EQ(onGpu->lastUpload().total(), sizeof(shared::GpuLight));
    builder.replaceMesh(0, unitSquare());
    need(onGpu->update(builder.snapshot));
    EXPECT_EQ(onGpu->lastUpload().geometryBytes, 4u * (28u + 16u) + 6u * 4u);
    EXPECT_EQ(onGpu->lastUpload().instanceBytes, sizeof(shared::GpuInstance));
}

TEST_F(ResidencyTest, SendsOneLayerOfTheTextures) {
    assets::Material material = mattMaterial();
    for (uint8_t i = 0; i < 3; ++i) builder.addImage({"image", 2, 2, std::vector<uint8_t>(16, i)});
    material.baseColourTexture.image = 0;
    material.emissiveTexture.image = 1;
    material.normalTexture.image = 2;
    builder.replaceMaterial(0, material);
    need(onGpu->update(builder.snapshot));
    EXPECT_EQ(onGpu->lastUpload().textureBytes, 3u * 16u);
    builder.snapshot.images[1] = {std::make_shared<assets::TextureImage>(assets::TextureImage{
                                      "new", 2, 2, std::vector<uint8_t>(16, 9)}),
                                  ++builder.lastVersion};
    builder.snapshot.materialVersion = builder.lastVersion;
    need(onGpu->update(builder.snapshot));
    EXPECT_EQ(onGpu->lastUpload().textureBytes, 16u);
}

TEST_F(ResidencyTest, HoldsInstancesAsTheyMoveAppearAndGo) {
    EXPECT_EQ(instances()[1].entity, 1u);
    builder.moveInstance(0, glm::translate(glm::mat4(1.0f), glm::vec3(5.0f, 0.0f, 0.0f)));
    const auto moved = instances();
    EXPECT_EQ(moved[0].objectToWorld0.w, 5.0f);
    EXPECT_EQ(moved[1].entity, 1u);
    for (uint32_t i = 0; i < 100; ++i) builder.addInstance(i % 2, 0, anyTransform(i));
    const auto grown = instances();
    ASSERT_GE(grown.size(), 102u);
    EXPECT_EQ(grown[0].objectToWorld0.w, 5.0f) << "kept while the buffer grew";
    EXPECT_EQ(grown[101].entity, 101u);
    builder.snapshot.instances.erase(builder.snapshot.instances.begin());
    builder.snapshot.geometryVersion = ++builder.lastVersion;
    EXPECT_EQ(instances()[0].entity, 1u);
}

TEST_F(ResidencyTest, PutsMeshesWhereTheDrawsSay) {
    need(onGpu->update(builder.snapshot));
    builder.replaceMesh(0, triangleSoup(40, 1.0f, 5));  // leaves a gap and grows the streams
    builder.addInstance(builder.addMesh(unitSquare()), 0);
    const auto positions = contents<std::byte>([](const auto& h) { return h.positions; });
    const auto& draws = onGpu->draws();
    ASSERT_EQ(draws.size(), 3u);
    EXPECT_FALSE(draws[0].hasTexcoords);
    EXPECT_TRUE(draws[2].hasTexcoords);
    for (const residency::DrawItem& draw : draws) {
        const auto& instance = builder.snapshot.instances[draw.instance];
        const auto& mesh = *builder.snapshot.meshes[instance.mesh].value;
        EXPECT_EQ(draw.indexCount, mesh.indices.size());
        const auto packed = residency::packPositions(mesh.positions);
        const size_t bytes = packed.size() * sizeof(residency::DevicePosition);
        ASSERT_LE(draw.positionOffsetBytes + bytes, positions.size());
        EXPECT_EQ(std::memcmp(positions.data() + draw.positionOffsetBytes, packed.data(), bytes),
                  0);
    }
}

TEST_F(ResidencyTest, IsThereForAnEmptyScene) {
    builder = {};
    EXPECT_FALSE(instances().empty());
    EXPECT_TRUE(onGpu->draws().empty());
    EXPECT_TRUE(onGpu->emitters().empty());
}

TEST_F(ResidencyTest, GrowsBuffersWithoutLosingWhatTheyHold) {
    static execute::Executor executor = need(execute::Executor::create(device()));
    residency::ResidentBuffer buffer(device(), "growing");
    const auto run = [&] {
        graph::Frame frame;
        execute::RunOptions options;
        options.readBackBuffers = {buffer.import(frame, "upload growing")};
        return valuesOf<uint32_t>(need(executor.run(frame, options)).buffers[0]);
    };
    const std::vector<uint32_t> values = {1, 2, 3, 4};
    need(buffer.reserve(16));
    need(buffer.stage(0, std::as_bytes(std::span(values))));
    EXPECT_EQ(run()[3], 4u);
    need(buffer.reserve(4096));
    need(buffer.stage(4080, std::as_bytes(std::span(values)).first(8)));
    need(buffer.stage(4, std::as_bytes(std::span(values)).first(4)));
    const auto after = run();
    EXPECT_EQ(after[0], 1u);
    EXPECT_EQ(after[1], 1u);
    EXPECT_EQ(after[2], 3u);
    EXPECT_EQ(after[1021], 2u);
}

}  // namespace
}  // namespace lampyris::test
