// Vertices that the morph and skin nodes pose, against scene::posedVertices.
#include <set>

#include "execute/executor.h"
#include "residency/pack_scene.h"
#include "residency/scene_on_gpu.h"
#include "support/gpu_test.h"
#include "support/posed_meshes.h"

namespace lampyris::test {
namespace {

class PoseTest : public GpuTest {
 protected:
    PoseTest() {
        if (!sharedDevice().ok()) return;
        onGpu.emplace(device());
        builder.addMaterial(mattMaterial());
    }

    uint32_t addPosed(uint32_t mesh, std::shared_ptr<const scene::Pose> pose) {
        const uint32_t index = builder.addInstance(mesh, 0, anyTransform(nextEntity));
        builder.snapshot.instances[index].entity = ecs::Entity{nextEntity++};
        setPose(builder, index, std::move(pose));
        return index;
    }

    /// update, import and run; keeps the streams and the names of the nodes.
    void runFrame(bool update = true) {
        static execute::Executor executor = need(execute::Executor::create(device()));
        if (update) need(onGpu->update(builder.snapshot));
        graph::Frame frame;
        const auto handles = residency::importScene(frame, *onGpu);
        execute::RunOptions options;
        for (const graph::Buffer source :
             {handles.positions, handles.normals, handles.tangents, handles.positionsBefore}) {
            const uint64_t bytes = frame.desc(source).bytes;
            const graph::Buffer copy = frame.buffer("copy", {bytes});
            options.readBackBuffers.push_back(
                frame.transfer("copy").copy(source, 0, copy, 0, bytes));
            frame.output(options.readBackBuffers.back());
        }
        nodes.clear();
        for (const auto& node : frame.nodes()) nodes.insert(node.name);
        const auto result = need(executor.run(frame, options));
        positions = valuesOf<glm::vec4>(result.buffers[0]);
        normals = valuesOf<glm::vec3>(result.buffers[1]);
        tangents = valuesOf<glm::vec4>(result.buffers[2]);
        before = valuesOf<glm::vec4>(result.buffers[3]);
    }

    [[nodiscard]] const residency::DrawItem& drawOf(uint32_t instance) const {
        for (const auto& item : onGpu->draws())
            if (item.instance == instance) return item;
        throw std::runtime_error("not drawn");
    }
    [[nodiscard]] scene::PosedVertices expected(uint32_t index) const {
        const auto& instance = builder.snapshot.instances[index];
        const assets::Mesh& mesh = *builder.snapshot.meshes[instance.mesh].value;
        return scene::posedVertices(mesh, *instance.pose);
    }

    /// Largest difference of any component, as a share of the largest component.
    template <typename T, typename S>
    static float difference(const std::vector<T>& wanted, const std::vector<S>& stream,
                            uint64_t first) {
        float largest = 1e-3f;
        float off = 0.0f;
        for (size_t i = 0; i < wanted.size(); ++i)
            for (int c = 0; c < T::length(); ++c) {
                const float d = std::abs(wanted[i][c] - stream.at(first + i)[c]);
                if (std::isnan(d)) return d;
                off = std::max(off, d);
                largest = std::max(largest, std::abs(wanted[i][c]));
            }
        return off / largest;
    }

    void expectPosed() {
        for (const auto& posed : onGpu->posed()) {
            const auto wanted = expected(posed.instance);
            const auto& item = drawOf(posed.instance);
            EXPECT_TRUE(item.posed);
            EXPECT_EQ(item.positionOffsetBytes,
                      posed.firstVertex * sizeof(residency::DevicePosition));
            EXPECT_LE(difference(wanted.positions, positions, posed.firstVertex), 1e-5f);
            EXPECT_LE(difference(wanted.normals, normals, posed.firstVertex), 1e-5f);
            if (wanted.tangents.empty()) continue;
            EXPECT_LE(difference(wanted.tangents, tangents, item.tangentOffsetBytes / 16), 1e-5f);
        }
    }

    SnapshotBuilder builder;
    std::optional<residency::SceneOnGpu> onGpu;
    uint32_t nextEntity = 0;
    std::set<std::string> nodes;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec4> positions, before, tangents;
};

TEST_F(PoseTest, EqualsTheCpuForAnySkinsAndMorphs) {
    uint32_t seed = 1;
    for (const uint32_t joints : {0u, 1u, 3u, 40u})
        for (const uint32_t targets : {0u, 1u, 5u}) {
            const auto soup = deformableSoup(20 + seed, joints, targets, seed, seed % 3 != 0);
            const uint32_t mesh = builder.addMesh(soup);
            for (int twin = 0; twin < 2; ++twin) addPosed(mesh, anyPose(joints, targets, seed++));
        }
    builder.addInstance(builder.addMesh(triangleSoup(9, 1.0f, 3)), 0);
    builder.snapshot.instances.back().entity = ecs::Entity{1000};
    runFrame();
    ASSERT_EQ(onGpu->posed().size(), 24u);
    EXPECT_TRUE(nodes.contains("morph") && nodes.contains("skin"));
    expectPosed();
    for (uint32_t frame = 0; frame < 3; ++frame) {
        for (uint32_t i = frame; i < 24; i += 3) {
            const auto& pose = *builder.snapshot.instances[i].pose;
            setPose(builder, i,
                    anyPose(static_cast<uint32_t>(pose.jointMatrices.size()),
                            static_cast<uint32_t>(pose.morphWeights.size()), seed++));
        }
        runFrame();
        expectPosed();
    }
}

TEST_F(PoseTest, DispatchesOnlyWhatChanges) {
    const uint32_t skinned =
        addPosed(builder.addMesh(deformableSoup(9, 4, 0, 1)), anyPose(4, 0, 2));
    const uint32_t morphed =
        addPosed(builder.addMesh(deformableSoup(9, 0, 2, 3)), anyPose(0, 2, 4));
    runFrame();
    EXPECT_TRUE(nodes.contains("morph") && nodes.contains("skin"));
    runFrame();
    EXPECT_EQ(onGpu->lastUpload().total(), 0u);
    EXPECT_FALSE(nodes.contains("morph") || nodes.contains("skin") ||
                 nodes.contains("upload poses"));
    expectPosed();
    setPose(builder, skinned, anyPose(4, 0, 5));
    runFrame();
    EXPECT_EQ(onGpu->lastUpload().poseBytes, 4u * 48u);
    EXPECT_EQ(onGpu->lastUpload().total(), 4u * 48u + sizeof(shared::GpuInstance));
    EXPECT_TRUE(!nodes.contains("morph") && nodes.contains("skin"));
    setPose(builder, morphed, anyPose(0, 2, 5));
    runFrame();
    EXPECT_TRUE(nodes.contains("morph") && !nodes.contains("skin"));
    expectPosed();
    builder.moveInstance(skinned, anyTransform(77));
    runFrame();
    EXPECT_FALSE(nodes.contains("morph") || nodes.contains("skin"));
    expectPosed();
}

TEST_F(PoseTest, KeepsWherePosedVerticesStoodBefore) {
    const uint32_t both = addPosed(builder.addMesh(deformableSoup(30, 6, 3, 1)), anyPose(6, 3, 2));
    const uint32_t skinned =
        addPosed(builder.addMesh(deformableSoup(8, 2, 0, 5)), anyPose(2, 0, 2));
    runFrame();
    EXPECT_FALSE(drawOf(both).moved) << "what is new has not moved";
    for (uint32_t frame = 0; frame < 2; ++frame) {
        const std::array was = {expected(both), expected(skinned)};
        setPose(builder, both, anyPose(6, 3, 10 + frame));
        setPose(builder, skinned, anyPose(2, 0, 20 + frame));
        runFrame();
        for (int again = 0; again < 2; ++again) {
            for (uint32_t i = 0; i < 2; ++i) {
                const auto& item = drawOf(i == 0 ? both : skinned);
                EXPECT_TRUE(item.moved && item.reposed);
                EXPECT_LE(difference(was[i].positions, before, item.positionBeforeOffsetBytes / 16),
                          1e-5f);
            }
            runFrame(false);  // a frame drawn once more, as where buffers were too small
        }
        expectPosed();
    }
    runFrame();
    EXPECT_FALSE(drawOf(both).moved || drawOf(both).reposed || drawOf(skinned).moved);
    const glm::mat4 place = builder.snapshot.instances[both].objectToWorld;
    builder.moveInstance(both, anyTransform(99));
    runFrame();
    EXPECT_TRUE(drawOf(both).moved);
    EXPECT_FALSE(drawOf(both).reposed);
    EXPECT_EQ(drawOf(both).objectToWorldBefore, place);
    EXPECT_FALSE(drawOf(skinned).moved);
}

TEST_F(PoseTest, PutsWhatHasNoJointsLeftBackToRest) {
    const uint32_t mesh = builder.addMesh(deformableSoup(9, 3, 2, 1));
    const uint32_t posed = addPosed(mesh, anyPose(3, 2, 2));
    runFrame();
    setPose(builder, posed, std::make_shared<scene::Pose>());
    runFrame();
    expectPosed();
    EXPECT_EQ(positions.at(onGpu->posed()[0].firstVertex),
              glm::vec4(builder.snapshot.meshes[mesh].value->positions[0], 0.0f));
    setPose(builder, posed, nullptr);
    runFrame();
    EXPECT_TRUE(onGpu->posed().empty());
    EXPECT_FALSE(drawOf(posed).posed);
}

TEST_F(PoseTest, PassesOnWhatIsNotFiniteAndFlattens) {
    auto pose = std::make_shared<scene::Pose>();
    pose->jointMatrices = {glm::mat4(std::numeric_limits<float>::quiet_NaN())};
    const uint32_t mesh = builder.addMesh(deformableSoup(4, 1, 0, 1));
    addPosed(mesh, pose);
    auto flat = std::make_shared<scene::Pose>();
    flat->jointMatrices = {glm::scale(glm::mat4(1.0f), glm::vec3(1.0f, 1.0f, 0.0f))};
    addPosed(mesh, flat);
    auto point = std::make_shared<scene::Pose>();
    point->jointMatrices = {glm::mat4(0.0f)};
    addPosed(mesh, point);
    runFrame();
    EXPECT_TRUE(std::isnan(positions.at(onGpu->posed()[0].firstVertex).x));
    for (uint32_t i = 1; i < 3; ++i) {
        EXPECT_LE(difference(expected(i).positions, positions, onGpu->posed()[i].firstVertex),
                  1e-5f);
        EXPECT_LE(difference(expected(i).normals, normals, onGpu->posed()[i].firstVertex), 1e-5f);
    }
}

TEST_F(PoseTest, KeepsMemoryFlatAsInstancesComeAndGo) {
    const uint32_t first = builder.addMesh(deformableSoup(40, 3, 1, 1));
    const uint32_t second = builder.addMesh(deformableSoup(60, 3, 1, 2));
    addPosed(first, anyPose(3, 1, 1));
    uint64_t bytes = 0;
    for (uint32_t round = 0; round < 200; ++round) {
        addPosed(second, anyPose(3, 1, round));
        builder.snapshot.instances[0].mesh = round % 2 == 0 ? second : first;
        setPose(builder, 0, anyPose(3, 1, round + 1));
        runFrame();
        if (round % 40 == 39) expectPosed();
        if (round == 9) bytes = onGpu->deviceBytes();
        builder.snapshot.instances.pop_back();
        builder.snapshot.geometryVersion = ++builder.lastVersion;
        runFrame();
        if (round % 40 == 39) expectPosed();
    }
    EXPECT_EQ(onGpu->deviceBytes(), bytes);
}

TEST_F(PoseTest, KeepsPosedVerticesWhileTheStreamsGrow) {
    addPosed(builder.addMesh(deformableSoup(40, 3, 1, 1)), anyPose(3, 1, 1));
    runFrame();
    builder.addInstance(builder.addMesh(triangleSoup(4000, 1.0f, 3)), 0);
    builder.snapshot.instances.back().entity = ecs::Entity{1000};
    runFrame();
    EXPECT_FALSE(nodes.contains("morph") || nodes.contains("skin"));
    expectPosed();
}

}  // namespace
}  // namespace lampyris::test
