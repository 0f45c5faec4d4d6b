#include <gtest/gtest.h>

#include "support/gltf_builder.h"

namespace lampyris::test {
namespace {

std::string errorOf(const std::vector<uint8_t>& bytes) {
    const auto result = assets::parseGltf(bytes, "test.glb");
    return result ? "(loaded)" : result.error().message;
}

std::vector<uint8_t> bytesOf(const std::string& text) {
    return {text.begin(), text.end()};
}

TEST(GltfContainer, TextAndBinaryGiveTheSameModel) {
    const GltfBuilder builder = GltfBuilder::triangle();
    const assets::Model text = builder.model();
    const auto binary = assets::parseGltf(builder.glb(), "test.glb");
    ASSERT_TRUE(binary) << binary.error().message;
    EXPECT_EQ(text.meshes.at(0).positions, binary->meshes.at(0).positions);
}

TEST(GltfContainer, EveryCutOfAGlbIsAnError) {
    const std::vector<uint8_t> whole = GltfBuilder::triangle().glb();
    for (size_t length = 0; length < whole.size(); ++length) {
        const std::vector<uint8_t> cut(whole.begin(), whole.begin() + static_cast<long>(length));
        EXPECT_TRUE(errorOf(cut).starts_with("test.glb: ")) << length;
    }
}

TEST(GltfContainer, HeaderAndChunkLengthsAreChecked) {
    std::vector<uint8_t> file = GltfBuilder::triangle().glb();
    std::vector<uint8_t> wrong = file;
    wrong[4] = 1;
    EXPECT_EQ(errorOf(wrong), "test.glb: is GLB version 1; only 2 is read");
    wrong = file;
    wrong[8] = 4;
    wrong[9] = wrong[10] = wrong[11] = 0;
    EXPECT_EQ(errorOf(wrong), "test.glb: the GLB's header says 4 bytes, fewer than itself");
    wrong = file;
    wrong[15] = 0xff;
    EXPECT_NE(errorOf(wrong).find("the GLB chunk at byte 12 reaches byte 42"), std::string::npos);
    wrong = file;
    wrong[16] = 'B';
    EXPECT_EQ(errorOf(wrong), "test.glb: the GLB's first chunk is not JSON");
}

TEST(GltfContainer, WhatIsNoGltfSaysSo) {
    EXPECT_EQ(errorOf({}), "test.glb: is empty");
    EXPECT_NE(errorOf(bytesOf("solid cube")).find("is no glTF: parse error at line 1"),
              std::string::npos);
    EXPECT_EQ(errorOf(bytesOf("[]")), "test.glb: is no glTF: its JSON is no object");
    EXPECT_EQ(errorOf(bytesOf("{}")), "test.glb: is no glTF: asset is missing");
    EXPECT_EQ(errorOf(bytesOf(R"({"asset":{"version":"1.0"}})")),
              "test.glb: /asset: is of glTF version 1.0; only 2 is read");
}

TEST(GltfContainer, DeepNestingIsAnErrorAndNoStackOverflow) {
    const std::string deep = std::string(1000000, '[') + std::string(1000000, ']');
    EXPECT_NE(errorOf(bytesOf(R"({"asset":{"version":"2.0"},"extras":)" + deep + "}"))
                  .find("nested deeper"),
              std::string::npos);
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["extras"] = {{"text", std::string(1000, '[') + "\\\""}};
    EXPECT_TRUE(builder.load());
}

TEST(GltfContainer, NumbersBeyondDoublesAreAnError) {
    EXPECT_NE(errorOf(bytesOf(R"({"asset":{"version":"2.0"},"extras":1e999})")).find("is no glTF"),
              std::string::npos);
}

TEST(GltfContainer, ExtensionsThatAreRequiredMustBeUnderstood) {
    GltfBuilder builder = GltfBuilder::triangle();
    builder.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
    EXPECT_EQ(logOf([&] { EXPECT_TRUE(builder.load()); }),
              "warning: test.gltf: is drawn without KHR_draco_mesh_compression\n");
    builder.json["extensionsRequired"] = {"KHR_texture_transform", "KHR_draco_mesh_compression"};
    EXPECT_EQ(builder.error(),
              "test.gltf: /extensionsRequired/1: the file requires KHR_draco_mesh_compression, "
              "which is not understood");
}

}  // namespace
}  // namespace lampyris::test
