#include "assets/mesh_repair.h"

#include <gtest/gtest.h>

namespace lampyris::assets {
namespace {

Mesh sliver(float height) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.5f, height, 0}};
    mesh.indices = {0, 1, 2};
    return mesh;
}

TEST(MeshRepair, ThinIsDrawnAndFlatIsNot) {
    Mesh thin = sliver(1e-5f);
    EXPECT_EQ(dropBrokenTriangles(thin).zeroArea, 0u);
    Mesh flat = sliver(0.0f);
    EXPECT_EQ(dropBrokenTriangles(flat).zeroArea, 1u);
    EXPECT_TRUE(flat.indices.empty());
}

TEST(MeshRepair, SizeDoesNotMatter) {
    for (const float scale : {1e-18f, 1.0f, 1e18f}) {
        Mesh mesh = sliver(1.0f);
        for (glm::vec3& position : mesh.positions) position *= scale;
        EXPECT_EQ(dropBrokenTriangles(mesh).zeroArea, 0u) << scale;
        makeFlatNormals(mesh);
        EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1)) << scale;
    }
}

TEST(MeshRepair, MorphTargetsMayOpenATriangleWithoutArea) {
    Mesh mesh = sliver(0.0f);
    mesh.morphTargets.resize(1);
    EXPECT_EQ(dropBrokenTriangles(mesh).zeroArea, 0u);
    mesh.indices = {0, 1, 1};
    EXPECT_EQ(dropBrokenTriangles(mesh).zeroArea, 1u);
}

TEST(MeshRepair, FlatNormalsGiveEveryCornerItsAttributes) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.texcoords0 = {{0, 0}, {1, 0}, {2, 0}, {3, 0}};
    mesh.morphTargets.resize(1);
    mesh.morphTargets[0].positions = {{9, 0, 0}, {8, 0, 0}, {7, 0, 0}, {6, 0, 0}};
    mesh.indices = {0, 1, 2, 0, 3, 1};
    makeFlatNormals(mesh);
    EXPECT_EQ(mesh.indices, (std::vector<uint32_t>{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(mesh.texcoords0.at(4), glm::vec2(3, 0));
    EXPECT_EQ(mesh.morphTargets[0].positions.at(4), glm::vec3(6, 0, 0));
    EXPECT_EQ(mesh.normals.at(0), glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.normals.at(3), glm::vec3(0, 1, 0));
}

}  // namespace
}  // namespace lampyris::assets
