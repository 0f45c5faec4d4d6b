#include <gtest/gtest.h>

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

}  // namespace
}  // namespace lampyris::test
