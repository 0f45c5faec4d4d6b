#include <gtest/gtest.h>

#include <limits>

#include "support/gltf_builder.h"

namespace lampyris::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A unit square in z = 0 as four vertices in strip order.
GltfBuilder square(int mode, const std::vector<uint8_t>& indices = {}) {
    GltfBuilder builder;
    Json primitive = {
        {"attributes",
         {{"POSITION", builder.addFloats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, "VEC3")}}},
        {"mode", mode}};
    if (!indices.empty()) primitive["indices"] = builder.addAccessor(indices, "SCALAR", kUbyte);
    builder.addMesh(primitive);
    return builder;
}

TEST(GltfMesh, WithoutNormalsEveryFaceIsFlat) {
    const assets::Mesh mesh = square(4, {0, 1, 2, 2, 1, 3}).model().meshes.at(0);
    EXPECT_EQ(mesh.positions.size(), 6u);
    EXPECT_EQ(mesh.triangleCount(), 2u);
    for (const glm::vec3& normal : mesh.normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.bounds.upper, glm::vec3(1, 1, 0));
}

TEST(GltfMesh, StripsAndFansFaceOneWay) {
    const assets::Mesh strip = square(5).model().meshes.at(0);
    EXPECT_EQ(strip.triangleCount(), 2u);
    for (const glm::vec3& normal : strip.normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
    const assets::Mesh fan = square(6, {0, 1, 3, 2}).model().meshes.at(0);
    EXPECT_EQ(fan.triangleCount(), 2u);
    for (const glm::vec3& normal : fan.normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
}

TEST(GltfMesh, PointsAndLinesAreLeftOut) {
    GltfBuilder builder = square(4, {0, 1, 2});
    builder.addMesh({{"attributes", {{"POSITION", 0}}}, {"mode", 1}});
    assets::Model model;
    EXPECT_EQ(logOf([&] { model = builder.model(); }),
              "warning: test.gltf: /meshes/1/primitives/0: points and lines are not drawn\n");
    EXPECT_EQ(model.meshes.size(), 1u);
    EXPECT_TRUE(model.nodes.at(1).primitives.empty());
    EXPECT_EQ(square(0).error(), "test.gltf: has no mesh that can be drawn");
}

TEST(GltfMesh, AnIndexWithoutAVertexIsAnError) {
    EXPECT_EQ(square(4, {0, 1, 4}).error(),
              "test.gltf: /meshes/0/primitives/0: index 2 is 4, and there are 4 vertices");
}

TEST(GltfMesh, OnlyTheVerticesThatAreUsedStay) {
    GltfBuilder builder = square(4, {1, 3, 2});
    builder.addAttribute("NORMAL", builder.addFloats({9, 9, 9, 0, 0, 2, 0, 0, 3, 0, 0, 4}, "VEC3"));
    const assets::Mesh mesh = builder.model().meshes.at(0);
    EXPECT_EQ(mesh.positions, (std::vector<glm::vec3>{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
    EXPECT_EQ(mesh.indices, (std::vector<uint32_t>{0, 2, 1}));
    EXPECT_EQ(mesh.normals, std::vector<glm::vec3>(3, {0, 0, 1}));
}

TEST(GltfMesh, TrianglesAtNanAreDroppedWithAWarning) {
    GltfBuilder builder;
    builder.addMesh(
        {{"attributes",
          {{"POSITION",
            builder.addFloats(
                {0, 0, 0, 1, 0, 0, 0, 1, 0, kNan, 0, 0, 1,
                 0, 0, 0, 1, 0, 0, 0, 0, 1, 0,    0, 0, std::numeric_limits<float>::infinity(),
                 0},
                "VEC3")}}}});
    assets::Model model;
    EXPECT_EQ(logOf([&] { model = builder.model(); }),
              "warning: test.gltf: /meshes/0/primitives/0: mesh shape: 2 triangles at NaN or "
              "infinity are left out\n");
    EXPECT_EQ(model.meshes.at(0).triangleCount(), 1u);
    EXPECT_EQ(model.meshes.at(0).positions.size(), 3u);
}

TEST(GltfMesh, TrianglesWithoutAreaAreDroppedWithOneWarning) {
    const GltfBuilder builder = square(4, {0, 1, 2, 0, 0, 1, 1, 1, 1});
    assets::Model model;
    EXPECT_EQ(logOf([&] { model = builder.model(); }),
              "warning: test.gltf: 2 triangles without area in 1 meshes are left out\n");
    EXPECT_EQ(model.meshes.at(0).triangleCount(), 1u);
    EXPECT_EQ(square(4, {0, 0, 1}).error(), "test.gltf: has no mesh that can be drawn");
}

TEST(GltfMesh, NormalsWithoutDirectionTakeTheFaces) {
    GltfBuilder builder = GltfBuilder::triangle();
    builder.addAttribute("NORMAL", builder.addFloats({0, 3, 0, 0, 0, 0, kNan, 0, 0}, "VEC3"));
    assets::Model model;
    EXPECT_NE(logOf([&] { model = builder.model(); }).find("2 normals have no direction"),
              std::string::npos);
    EXPECT_EQ(model.meshes.at(0).normals,
              (std::vector<glm::vec3>{{0, 1, 0}, {0, 0, 1}, {0, 0, 1}}));
}

TEST(GltfMesh, AttributesThatAreNotFiniteBecomeZero) {
    GltfBuilder builder = GltfBuilder::triangle();
    builder.addAttribute("TEXCOORD_0", builder.addFloats({0, 1, kNan, 1, 2, 3}, "VEC2"));
    assets::Model model;
    EXPECT_NE(logOf([&] { model = builder.model(); }).find("1 vertices have attributes"),
              std::string::npos);
    EXPECT_EQ(model.meshes.at(0).texcoords0, (std::vector<glm::vec2>{{0, 1}, {0, 0}, {2, 3}}));
}

TEST(GltfMesh, ColoursOfThreeComponentsAreOpaque) {
    GltfBuilder builder = GltfBuilder::triangle();
    builder.addAttribute(
        "COLOR_0", builder.addAccessor<uint16_t>({65535, 0, 0, 0, 65535, 0, 0, 0, 65535}, "VEC3",
                                                 kUshort, true));
    EXPECT_EQ(builder.model().meshes.at(0).colours,
              (std::vector<glm::vec4>{{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}}));
}

TEST(GltfMesh, BothTextureCoordinateSetsAreKept) {
    GltfBuilder builder = GltfBuilder::triangle();
    builder.addAttribute("TEXCOORD_0", builder.addFloats({0, 0, 1, 0, 0, 1}, "VEC2"));
    builder.addAttribute("TEXCOORD_1", builder.addFloats({5, 0, 6, 0, 5, 1}, "VEC2"));
    const assets::Mesh mesh = builder.model().meshes.at(0);
    EXPECT_EQ(mesh.texcoords0.at(1), glm::vec2(1, 0));
    EXPECT_EQ(mesh.texcoords1.at(1), glm::vec2(6, 0));
}

TEST(GltfMesh, AttributesMustBeAsLongAsThePositions) {
    GltfBuilder builder = GltfBuilder::triangle();
    builder.addAttribute("TEXCOORD_0", builder.addFloats({0, 0, 1, 0}, "VEC2"));
    EXPECT_EQ(builder.error(),
              "test.gltf: /meshes/0/primitives/0: TEXCOORD_0 has 2 elements, and there are 3 "
              "vertices");
}

TEST(GltfMesh, MorphTargetsComeWithTheirWeights) {
    GltfBuilder builder = GltfBuilder::triangle();
    const int moved = builder.addFloats({0, 0, 1, 0, 0, 2, 0, 0, 3}, "VEC3");
    builder.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", moved}},
                                                             {{"POSITION", 0}}};
    builder.json["meshes"][0]["weights"] = {0.25, 0.5};
    const assets::Mesh mesh = builder.model().meshes.at(0);
    ASSERT_EQ(mesh.morphTargets.size(), 2u);
    EXPECT_EQ(mesh.morphTargets[0].positions.at(2), glm::vec3(0, 0, 3));
    EXPECT_TRUE(mesh.morphTargets[0].normals.empty());
    EXPECT_EQ(mesh.morphWeights, (std::vector<float>{0.25f, 0.5f}));

    builder.json["meshes"][0]["primitives"][0]["targets"][1]["POSITION"] =
        builder.addFloats({0, 0, 0}, "VEC3");
    EXPECT_EQ(builder.error(),
              "test.gltf: /meshes/0/primitives/0/targets/1: POSITION has 1 elements, and there are "
              "3 vertices");
}

TEST(GltfMesh, JointWeightsAreMadeToSumToOne) {
    GltfBuilder builder = GltfBuilder::triangle();
    builder.addAttribute("JOINTS_0", builder.addAccessor<uint8_t>(
                                         {0, 0, 0, 0, 0, 0, 9, 0, 0, 0, 0, 0}, "VEC4", kUbyte));
    builder.addAttribute("WEIGHTS_0",
                         builder.addFloats({1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0}, "VEC4"));
    assets::Model model;
    EXPECT_NE(
        logOf([&] { model = builder.model(); }).find("joint weights of 2 vertices do not sum to 1"),
        std::string::npos);
    const assets::Mesh& mesh = model.meshes.at(0);
    EXPECT_EQ(mesh.weights,
              (std::vector<glm::vec4>{{1, 0, 0, 0}, {0.5f, 0.5f, 0, 0}, {1, 0, 0, 0}}));
    EXPECT_EQ(mesh.joints.at(1), glm::uvec4(0)) << "a joint of weight 0 is none";
}

}  // namespace
}  // namespace lampyris::test
