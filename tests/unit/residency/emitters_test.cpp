#include "residency/emitters.h"

#include <gtest/gtest.h>

#include "support/posed_meshes.h"

namespace lampyris::residency {
namespace {

assets::Material glowing(const glm::vec3& radiance) {
    assets::Material material = test::mattMaterial();
    material.emissiveRadiance = radiance;
    return material;
}

TEST(Emitters, HavePowerPiTimesRadianceTimesArea) {
    test::SnapshotBuilder scene;
    const uint32_t square = scene.addMesh(test::unitSquare());
    scene.addInstance(square, scene.addMaterial(test::mattMaterial()));
    scene.addInstance(square, scene.addMaterial(glowing({1.0f, 2.0f, 3.0f})),
                      glm::scale(glm::mat4(1.0f), glm::vec3(2.0f, 3.0f, 1.0f)));
    const EmitterTable table = buildEmitters(scene.snapshot);
    ASSERT_EQ(table.emitters.size(), 1u);
    const auto& emitter = table.emitters[0];
    EXPECT_EQ(emitter.instance, 1u);
    EXPECT_NEAR(emitter.power.x, 6.0f * math::kPi, 1e-4f);
    EXPECT_NEAR(emitter.power.z, 18.0f * math::kPi, 1e-4f);
    EXPECT_NEAR(emitter.power.w, 12.0f * math::kPi, 1e-4f);
    ASSERT_EQ(table.triangles.size(), 2u);
    EXPECT_FLOAT_EQ(table.triangles[0].areaSquareMetres, 3.0f);
    EXPECT_FLOAT_EQ(table.triangles[0].cumulative, 0.5f);
    EXPECT_FLOAT_EQ(table.triangles[1].cumulative, 1.0f);
}

TEST(Emitters, GlowWhereTheirPosePutsThem) {
    test::SnapshotBuilder scene;
    assets::Mesh square = test::unitSquare();
    square.joints.assign(4, glm::uvec4(0));
    square.weights.assign(4, glm::vec4(1.0f, 0.0f, 0.0f, 0.0f));
    scene.addInstance(scene.addMesh(square), scene.addMaterial(glowing(glm::vec3(1.0f))));
    auto pose = std::make_shared<scene::Pose>();
    pose->jointMatrices = {glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(0, 0, 5)),
                                      glm::vec3(2.0f, 2.0f, 1.0f))};
    const auto rest = emitterSignature(scene.snapshot);
    test::setPose(scene, 0, pose);
    EXPECT_NE(emitterSignature(scene.snapshot), rest);
    const EmitterTable table = buildEmitters(scene.snapshot);
    EXPECT_NEAR(table.emitters.at(0).power.x, 4.0f * math::kPi, 1e-4f);
    EXPECT_FLOAT_EQ(table.triangles.at(0).v0.z, 5.0f);
}

TEST(Emitters, GlowTwiceWhereDoubleSided) {
    test::SnapshotBuilder scene;
    assets::Material material = glowing(glm::vec3(1.0f));
    material.doubleSided = true;
    scene.addInstance(scene.addMesh(test::unitSquare()), scene.addMaterial(material));
    const EmitterTable table = buildEmitters(scene.snapshot);
    EXPECT_NEAR(table.emitters.at(0).power.x, 2.0f * math::kPi, 1e-4f);
    EXPECT_NE(table.emitters.at(0).flags & shared::INSTANCE_DOUBLE_SIDED, 0u);
}

TEST(Emitters, FaceOutwardsWhenMirrored) {
    test::SnapshotBuilder scene;
    const uint32_t square = scene.addMesh(test::unitSquare());
    const uint32_t material = scene.addMaterial(glowing(glm::vec3(1.0f)));
    scene.addInstance(square, material);
    scene.addInstance(square, material, glm::scale(glm::mat4(1.0f), glm::vec3(-1.0f, 1.0f, 1.0f)));
    for (const EmitterTriangle& triangle : buildEmitters(scene.snapshot).triangles)
        EXPECT_GT(glm::cross(triangle.e1, triangle.e2).z, 0.0f);
}

TEST(Emitters, AverageTheirTexture) {
    test::SnapshotBuilder scene;
    // A quarter of the texels are white, so a quarter of the light.
    std::vector<uint8_t> rgba(4 * 16 * 16, 0);
    for (size_t y = 0; y < 8; ++y)
        for (size_t x = 0; x < 8; ++x)
            for (size_t c = 0; c < 4; ++c) rgba[4 * (16 * y + x) + c] = 255;
    assets::Material material = glowing(glm::vec3(4.0f));
    material.emissiveTexture.image = scene.addImage({"corner", 16, 16, rgba});
    material.emissiveTexture.filter = assets::Filter::Nearest;
    scene.addInstance(scene.addMesh(test::unitSquare()), scene.addMaterial(material));
    EXPECT_NEAR(buildEmitters(scene.snapshot).emitters.at(0).power.x, math::kPi, 0.05f * math::kPi);
}

TEST(Emitters, LeaveOutTrianglesWithoutPower) {
    test::SnapshotBuilder scene;
    assets::Mesh mesh = test::unitSquare();
    mesh.positions.push_back(mesh.positions[0]);
    mesh.texcoords0.push_back({});
    mesh.indices.insert(mesh.indices.begin(), {0, 1, 4});  // no area
    scene.addInstance(scene.addMesh(mesh), scene.addMaterial(glowing(glm::vec3(1.0f))));
    const EmitterTable table = buildEmitters(scene.snapshot);
    ASSERT_EQ(table.triangles.size(), 2u);
    EXPECT_EQ(table.triangles[0].primitive, 1u);
}

TEST(Emitters, ShareThePowerOfTheWholeScene) {
    test::SnapshotBuilder scene;
    const uint32_t square = scene.addMesh(test::unitSquare());
    scene.addInstance(square, scene.addMaterial(glowing(glm::vec3(1.0f))));
    scene.addInstance(square, scene.addMaterial(glowing(glm::vec3(3.0f))));
    const EmitterTable table = buildEmitters(scene.snapshot);
    ASSERT_EQ(table.triangles.size(), 4u);
    EXPECT_FLOAT_EQ(table.triangles[0].cumulativeOfAll, 0.125f);
    EXPECT_FLOAT_EQ(table.triangles[1].cumulativeOfAll, 0.25f);
    EXPECT_FLOAT_EQ(table.triangles[2].cumulativeOfAll, 0.625f);
    EXPECT_EQ(table.triangles[3].cumulativeOfAll, 1.0f);
    EXPECT_FLOAT_EQ(table.triangles[2].cumulative, 0.5f);
}

TEST(Emitters, HaveASignatureThatFollowsWhatTheyDependOn) {
    test::SnapshotBuilder scene;
    const uint32_t square = scene.addMesh(test::unitSquare());
    const uint32_t dark = scene.addMaterial(test::mattMaterial());
    const uint32_t bright = scene.addMaterial(glowing(glm::vec3(1.0f)));
    scene.addInstance(square, dark);
    scene.addInstance(square, bright);
    const auto before = emitterSignature(scene.snapshot);
    scene.moveInstance(0, test::anyTransform(1));
    EXPECT_EQ(emitterSignature(scene.snapshot), before);
    scene.moveInstance(1, test::anyTransform(2));
    const auto moved = emitterSignature(scene.snapshot);
    EXPECT_NE(moved, before);
    scene.replaceMaterial(bright, glowing(glm::vec3(2.0f)));
    EXPECT_NE(emitterSignature(scene.snapshot), moved);
}

}  // namespace
}  // namespace lampyris::residency
