#include <gtest/gtest.h>

#include <limits>

#include "support/gltf_builder.h"

namespace lampyris::test {
namespace {

/// A triangle bound to joint `joint` of a skin of two.
GltfBuilder skinned(uint8_t joint) {
    GltfBuilder builder = GltfBuilder::triangle();
    builder.addAttribute(
        "JOINTS_0", builder.addAccessor<uint8_t>({joint, 0, 0, 0, joint, 0, 0, 0, joint, 0, 0, 0},
                                                 "VEC4", kUbyte));
    builder.addAttribute("WEIGHTS_0",
                         builder.addFloats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4"));
    builder.push("nodes", Json::object());
    builder.push("skins", {{"joints", {0, 1}}});
    builder.json["nodes"][0]["skin"] = 0;
    return builder;
}

TEST(GltfSkin, InverseBindMatricesAreIdentityWhereThereAreNone) {
    const assets::Model model = skinned(1).model();
    EXPECT_EQ(model.skins.at(0).joints, (std::vector<uint32_t>{0, 1}));
    EXPECT_EQ(model.skins.at(0).inverseBindMatrices, std::vector<glm::mat4>(2, glm::mat4(1.0f)));
    EXPECT_EQ(model.meshes.at(0).joints.at(0), glm::uvec4(1, 0, 0, 0));
    EXPECT_EQ(model.nodes.at(0).skin, 0);
}

TEST(GltfSkin, InverseBindMatricesAreColumnsFirst) {
    GltfBuilder builder = skinned(0);
    std::vector<float> numbers(32);
    for (size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<float>(i);
    builder.json["skins"][0]["inverseBindMatrices"] = builder.addFloats(numbers, "MAT4");
    EXPECT_EQ(builder.model().skins.at(0).inverseBindMatrices.at(1)[2][3], 16.0f + 2 * 4 + 3);
    numbers.resize(16);
    builder.json["skins"][0]["inverseBindMatrices"] = builder.addFloats(numbers, "MAT4");
    EXPECT_EQ(builder.error(), "test.gltf: /skins/0: has 2 joints and 1 inverse bind matrices");
}

TEST(GltfSkin, AJointThatTheSkinHasNotIsAnError) {
    EXPECT_EQ(skinned(2).error(),
              "test.gltf: /nodes/0: mesh shape has the joint 2, and skin 0 has 2");
}

TEST(GltfSkin, AMatrixThatIsNotFiniteIsAnError) {
    GltfBuilder builder = skinned(0);
    std::vector<float> numbers(32, 1.0f);
    numbers[20] = std::numeric_limits<float>::infinity();
    builder.json["skins"][0]["inverseBindMatrices"] = builder.addFloats(numbers, "MAT4");
    EXPECT_EQ(builder.error(), "test.gltf: /skins/0: an inverse bind matrix is not finite");
}

TEST(GltfSkin, MoreThanFourJointsOrHalfABindingAreWarnings) {
    GltfBuilder builder = skinned(1);
    const Json attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
    builder.addAttribute("JOINTS_1", attributes["JOINTS_0"]);
    assets::Model model;
    EXPECT_NE(logOf([&] {
                  model = builder.model();
              }).find("/meshes/0/primitives/0: only four joints a vertex are read"),
              std::string::npos);
    EXPECT_EQ(model.meshes.at(0).joints.size(), 3u);
    for (const char* half : {"JOINTS_0", "WEIGHTS_0"}) {
        builder = skinned(1);
        builder.json["meshes"][0]["primitives"][0]["attributes"].erase(half);
        EXPECT_NE(logOf([&] {
                      model = builder.model();
                  }).find("/meshes/0/primitives/0: has only one of JOINTS_0 and WEIGHTS_0"),
                  std::string::npos);
        EXPECT_TRUE(model.meshes.at(0).joints.empty());
        EXPECT_TRUE(model.meshes.at(0).weights.empty());
    }
}

TEST(GltfSkin, WeightsThatAreNoNumbersFollowTheFirstJoint) {
    GltfBuilder builder = skinned(1);
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    builder.addAttribute("WEIGHTS_0",
                         builder.addFloats({kNone, 0, 0, 0, -1, 2, 0, 0, 0, 0, 0, 0}, "VEC4"));
    assets::Model model;
    EXPECT_NE(
        logOf([&] { model = builder.model(); }).find("joint weights of 3 vertices do not sum to 1"),
        std::string::npos);
    for (const glm::vec4& weights : model.meshes.at(0).weights)
        EXPECT_EQ(weights.x + weights.y + weights.z + weights.w, 1.0f);
}

}  // namespace
}  // namespace lampyris::test
