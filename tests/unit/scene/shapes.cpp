#include "scene/builtin/shapes.h"

#include <gtest/gtest.h>

#include "unit/scene/mesh_facts.h"

namespace lampyris::scene::builtin {
namespace {

using test::area;
using test::EdgeCount;
using test::flaws;
using test::volume;

void expectClosed(const assets::Mesh& mesh) {
    EdgeCount edges;
    edges.add(mesh);
    EXPECT_EQ(edges.unpaired(), 0u);
    EXPECT_EQ(flaws(mesh), 0u);
}

TEST(Shapes, BoxIsClosedAndKeepsItsSizeWhenTurned) {
    assets::Mesh mesh;
    addBox(mesh, placed({3.0f, -2.0f, 5.0f}, 33.0), {1.0f, 2.0f, 0.5f});
    EXPECT_EQ(mesh.triangleCount(), 12u);
    EXPECT_NEAR(area(mesh), 28.0, 1e-5);
    EXPECT_NEAR(volume(mesh), 8.0, 1e-4);
    expectClosed(mesh);
}

TEST(Shapes, SphereIsClosedAndNearlyRound) {
    assets::Mesh mesh;
    addSphere(mesh, {1.0f, 2.0f, 3.0f}, 2.0f, 40);
    EXPECT_EQ(mesh.triangleCount(), 12u * 40 * 40);
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 out = (mesh.positions[i] - glm::vec3(1, 2, 3)) / 2.0f;
        ASSERT_NEAR(glm::length(out - mesh.normals[i]), 0.0f, 1e-6f);
    }
    EXPECT_NEAR(volume(mesh), 4.0 / 3.0 * math::kPi * 8.0, 0.06);
    expectClosed(mesh);
}

TEST(Shapes, RoundedBoxFillsItsExtentAndIsClosed) {
    assets::Mesh mesh;
    addRoundedBox(mesh, placed({}), {{1.0f, 0.3f, 2.0f}, 0.25f, 3, 2});
    EXPECT_EQ(mesh.triangleCount(), 12u * 8 * 8);
    assets::updateBounds(mesh);
    EXPECT_EQ(mesh.bounds.upper, glm::vec3(1.0f, 0.3f, 2.0f));
    EXPECT_EQ(mesh.bounds.lower, glm::vec3(-1.0f, -0.3f, -2.0f));
    EXPECT_LT(volume(mesh), 2.0 * 0.6 * 4.0);
    EXPECT_GT(volume(mesh), 0.8 * 2.0 * 0.6 * 4.0);
    EXPECT_EQ(flaws(mesh), 0u);
}

TEST(Shapes, CylinderAndTorusHaveTheirVolumes) {
    assets::Mesh cylinder;
    addCylinder(cylinder, placed({1.0f, 0.0f, 0.0f}), 0.5f, 3.0f, 96);
    EXPECT_EQ(cylinder.triangleCount(), 4u * 96 - 4);
    EXPECT_NEAR(volume(cylinder), math::kPi * 0.25 * 3.0, 0.003);
    expectClosed(cylinder);
    assets::Mesh torus;
    addTorus(torus, placed({0.0f, 1.0f, 0.0f}, 10.0), 2.0f, 0.5f, 128, 64);
    EXPECT_NEAR(volume(torus), 2.0 * math::kPi * math::kPi * 2.0 * 0.25, 0.03);
    expectClosed(torus);
}

TEST(Shapes, TubeKeepsItsRadiusRoundCorners) {
    const std::vector<glm::vec3> path{{0, 0, 0}, {0, 1, 0}, {0.2f, 2, 0}, {1, 2.5f, 0.3f}};
    assets::Mesh mesh;
    addTube(mesh, path, 0.05f, 6);
    EXPECT_EQ(mesh.triangleCount(), 2u * 6 * 3);
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        EXPECT_NEAR(glm::distance(mesh.positions[i], path[i / 6]), 0.05f, 1e-6f);
    }
    EXPECT_EQ(flaws(mesh), 0u);
}

}  // namespace
}  // namespace lampyris::scene::builtin
