// Posed instances are drawn as meshes of their own.
#include <gtest/gtest.h>

#include "support/deformed_meshes.h"
#include "unit/reference/scenes.h"

namespace lampyris::reference {
namespace {

/// The mesh as the pose leaves it, with nothing left to bend.
assets::Mesh baked(const assets::Mesh& mesh, const scene::Pose& pose) {
    scene::PosedVertices posed = scene::posedVertices(mesh, pose);
    assets::Mesh result;
    result.positions = std::move(posed.positions);
    result.normals = std::move(posed.normals);
    result.indices = mesh.indices;
    return result;
}

/// Two instances of one mesh in two poses, as poses or as meshes.
scene::SceneSnapshot twoPoses(bool asMeshes, uint32_t joints = 3) {
    const assets::Mesh mesh = test::bendableSoup(40, joints, 2, 11, 0.5f);
    scene::SceneSnapshot snapshot;
    addInstance(snapshot, floorMesh(), lambertian(glm::vec3(0.5f)));
    for (uint32_t i = 0; i < 2; ++i) {
        const scene::Pose pose = test::anyPose(joints, 2, i, 0.5f);
        const glm::mat4 matrix =
            glm::translate(glm::mat4(1.0f), glm::vec3(4.0f * static_cast<float>(i) - 2, 1, 0));
        addInstance(snapshot, asMeshes ? baked(mesh, pose) : mesh, lambertian(glm::vec3(0.7f)),
                    matrix);
        if (asMeshes) continue;
        scene::SnapshotInstance& instance = snapshot.instances.back();
        instance.mesh = 1;
        instance.pose = std::make_shared<const scene::Pose>(pose);
    }
    addLight(snapshot, {0, 4, 2}, 0.2f, 100.0f);
    return snapshot;
}

TEST(PosedMesh, IsDrawnAsAMeshOfItsVertices) {
    const auto camera = lookFrom({0, 2, 6}, {0, 1, 0});
    const Settings settings = settingsFor(48, 27, 4);
    const Rendered posed = rendered(twoPoses(false), camera, settings);
    const Rendered plain = rendered(twoPoses(true), camera, settings);
    EXPECT_EQ(posed.final.values, plain.final.values);
    EXPECT_EQ(posed.normal.values, plain.normal.values);
    EXPECT_GT(meanOf(plain.final).x, 0.0);
}

TEST(PosedMesh, LeavesOutWhatItPutsAtInfinity) {
    scene::SceneSnapshot snapshot = twoPoses(false, 20);
    scene::Pose pose{{0, 0}, std::vector<glm::mat4>(20, glm::mat4(1.0f))};
    pose.jointMatrices[2] = glm::mat4(std::numeric_limits<float>::infinity());
    snapshot.instances[1].pose = std::make_shared<const scene::Pose>(pose);
    const RayScene scene = built(snapshot);
    ASSERT_NE(scene.placed(1), nullptr);
    EXPECT_LT(scene.placed(1)->mesh->triangleCount(), 40u);
    for (const glm::vec3& p : scene.placed(1)->positionsWorld)
        EXPECT_TRUE(std::isfinite(glm::dot(p, p)));
    pose.jointMatrices.assign(20, pose.jointMatrices[2]);
    snapshot.instances[1].pose = std::make_shared<const scene::Pose>(pose);
    EXPECT_EQ(built(snapshot).placed(1), nullptr);
}

}  // namespace
}  // namespace lampyris::reference
