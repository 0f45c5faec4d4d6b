#include <gtest/gtest.h>

#include <cmath>

#include "support/gltf_builder.h"

namespace lampyris::test {
namespace {

/// The texture coordinates of a triangle that reads them from this accessor.
std::vector<glm::vec2> texcoordsOf(GltfBuilder builder, int accessor) {
    builder.addAttribute("TEXCOORD_0", accessor);
    const assets::Model model = builder.model();
    return model.meshes.empty() ? std::vector<glm::vec2>{} : model.meshes[0].texcoords0;
}

TEST(GltfAccessor, NormalizedIntegersReachOneAndMinusOne) {
    GltfBuilder builder = GltfBuilder::triangle();
    const std::vector<glm::vec2> expected = {{0, 1}, {1, 0}, {0, 0}};
    EXPECT_EQ(texcoordsOf(builder, builder.addAccessor<uint8_t>({0, 255, 255, 0, 0, 0}, "VEC2",
                                                                kUbyte, true)),
              expected);
    builder = GltfBuilder::triangle();
    EXPECT_EQ(texcoordsOf(builder, builder.addAccessor<uint16_t>({0, 65535, 65535, 0, 0, 0}, "VEC2",
                                                                 kUshort, true)),
              expected);
    builder = GltfBuilder::triangle();
    EXPECT_EQ(texcoordsOf(builder, builder.addAccessor<int8_t>({-128, 127, -127, 0, 0, 0}, "VEC2",
                                                               kByte, true)),
              (std::vector<glm::vec2>{{-1, 1}, {-1, 0}, {0, 0}}));
    builder = GltfBuilder::triangle();
    EXPECT_EQ(texcoordsOf(builder, builder.addAccessor<int16_t>({-32768, 32767, 0, 0, 0, 0}, "VEC2",
                                                                kShort, true)),
              (std::vector<glm::vec2>{{-1, 1}, {0, 0}, {0, 0}}));
}

TEST(GltfAccessor, IntegersThatAreNotNormalizedKeepTheirValue) {
    GltfBuilder builder = GltfBuilder::triangle();
    EXPECT_EQ(
        texcoordsOf(builder, builder.addAccessor<int16_t>({-3, 300, 0, 0, 0, 7}, "VEC2", kShort)),
        (std::vector<glm::vec2>{{-3, 300}, {0, 0}, {0, 7}}));
}

TEST(GltfAccessor, InterleavedAttributesShareAView) {
    GltfBuilder builder;
    const std::vector<float> numbers = {0, 0, 0, 10, 11, 1, 0, 0, 20, 21, 0, 1, 0, 30, 31};
    std::vector<uint8_t> data(numbers.size() * sizeof(float));
    std::memcpy(data.data(), numbers.data(), data.size());
    const int view = builder.addView(data, 20);
    const Json common = {{"bufferView", view}, {"componentType", kFloat}, {"count", 3}};
    Json position = common;
    position["type"] = "VEC3";
    Json texcoord = common;
    texcoord["type"] = "VEC2";
    texcoord["byteOffset"] = 12;
    builder.addMesh({{"attributes",
                      {{"POSITION", builder.push("accessors", position)},
                       {"TEXCOORD_0", builder.push("accessors", texcoord)}}}});
    const assets::Model model = builder.model();
    EXPECT_EQ(model.meshes.at(0).positions,
              (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(model.meshes.at(0).texcoords0,
              (std::vector<glm::vec2>{{10, 11}, {20, 21}, {30, 31}}));
}

GltfBuilder sparseTriangle(const std::vector<uint8_t>& indices, bool withBase) {
    GltfBuilder builder;
    Json accessor = {{"componentType", kFloat}, {"type", "VEC3"}, {"count", 3}};
    if (withBase) {
        builder.addFloats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
        accessor = builder.json["accessors"][0];
    }
    const std::vector<float> values = {5, 0, 0, 0, 6, 0};
    std::vector<uint8_t> data(values.size() * sizeof(float));
    std::memcpy(data.data(), values.data(), data.size());
    accessor["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", builder.addView(indices)}, {"componentType", kUbyte}}},
        {"values", {{"bufferView", builder.addView(data)}}}};
    builder.addMesh({{"attributes", {{"POSITION", builder.push("accessors", accessor)}}}});
    return builder;
}

TEST(GltfAccessor, SparseValuesReplaceTheBaseOrZeros) {
    const std::vector<glm::vec3> expected = {{0, 0, 0}, {5, 0, 0}, {0, 6, 0}};
    EXPECT_EQ(sparseTriangle({1, 2}, true).model().meshes.at(0).positions, expected);
    EXPECT_EQ(sparseTriangle({1, 2}, false).model().meshes.at(0).positions, expected);
}

TEST(GltfAccessor, SparseIndicesMustRiseAndExist) {
    EXPECT_EQ(sparseTriangle({1, 3}, true).error(),
              "test.gltf: /accessors/1/sparse: index 1 is 3, after 1, and there are 3 elements");
    EXPECT_EQ(sparseTriangle({2, 1}, true).error(),
              "test.gltf: /accessors/1/sparse: index 1 is 1, after 2, and there are 3 elements");
}

TEST(GltfAccessor, AnAttributeOfAnotherTypeIsAnError) {
    GltfBuilder builder = GltfBuilder::triangle();
    builder.addAttribute("NORMAL", builder.addFloats({0, 0, 0, 0, 0, 0}, "VEC2"));
    EXPECT_EQ(builder.error(),
              "test.gltf: /accessors/1: has 2 components of componentType 5126, and 3 numbers are "
              "needed");
}

TEST(GltfAccessor, FloatsAreNoIndices) {
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["meshes"][0]["primitives"][0]["indices"] = builder.addFloats({0, 1, 2}, "SCALAR");
    EXPECT_NE(builder.error().find("1 unsigned integers are needed"), std::string::npos);
}

}  // namespace
}  // namespace lampyris::test
