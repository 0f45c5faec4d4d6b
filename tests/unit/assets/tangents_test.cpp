#include "assets/tangents.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lampyris::assets {
namespace {

/// A square in z = 0 facing +z; texture coordinates as an upright image has them: v falls upwards.
Mesh upright() {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.texcoords0 = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

TEST(Tangents, AnUprightImageHasItsBitangentUp) {
    Mesh mesh = upright();
    generateTangents(mesh, 0);
    EXPECT_EQ(mesh.tangents, std::vector<glm::vec4>(4, {1, 0, 0, 1}));
}

TEST(Tangents, AMirroredImageHasMinusOne) {
    Mesh mesh = upright();
    for (glm::vec2& uv : mesh.texcoords0) uv.x = -uv.x;
    generateTangents(mesh, 0);
    EXPECT_EQ(mesh.tangents, std::vector<glm::vec4>(4, {-1, 0, 0, -1}));
}

TEST(Tangents, ArePerpendicularToBentNormals) {
    Mesh mesh = upright();
    for (size_t i = 0; i < 4; ++i)
        mesh.normals[i] = glm::normalize(glm::vec3(mesh.positions[i].x - 0.5f, 0.2f, 0.8f));
    generateTangents(mesh, 0);
    for (size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(glm::dot(glm::vec3(mesh.tangents[i]), mesh.normals[i]), 0.0f, 1e-6f);
        EXPECT_NEAR(glm::length(glm::vec3(mesh.tangents[i])), 1.0f, 1e-6f);
    }
}

TEST(Tangents, CoordinatesThatDoNotVaryGiveAnyPerpendicular) {
    Mesh mesh = upright();
    mesh.texcoords1.assign(4, {0.5f, 0.5f});
    generateTangents(mesh, 1);
    for (size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(glm::dot(glm::vec3(mesh.tangents[i]), mesh.normals[i]), 0.0f, 1e-6f);
        EXPECT_NEAR(glm::length(glm::vec3(mesh.tangents[i])), 1.0f, 1e-6f);
    }
}

TEST(Tangents, GivenOnesAreMadeUnit) {
    Mesh mesh = upright();
    mesh.tangents = {{2, 0, 0, 1}, {0, 0, 0, 1}, {0, 3, 0, -0.5f}, {NAN, 0, 0, 1}};
    normalizeTangents(mesh);
    EXPECT_EQ(mesh.tangents[0], glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(mesh.tangents[2], glm::vec4(0, 1, 0, -1));
    EXPECT_NEAR(glm::length(glm::vec3(mesh.tangents[1])), 1.0f, 1e-6f);
    EXPECT_NEAR(glm::length(glm::vec3(mesh.tangents[3])), 1.0f, 1e-6f);
}

}  // namespace
}  // namespace lampyris::assets
