#include <gtest/gtest.h>

#include "support/gltf_builder.h"
#include "support/png_bytes.h"

namespace lampyris::test {
namespace {

/// A triangle with texture coordinates and one material; texture 0 is a 1x1 image.
GltfBuilder textured(const Json& material) {
    GltfBuilder builder = GltfBuilder::triangle();
    builder.addAttribute("TEXCOORD_0", builder.addFloats({0, 0, 1, 0, 0, 1}, "VEC2"));
    builder.push("images", {{"bufferView", builder.addView(pngBytes(1, 1, {1, 2, 3, 4}))},
                            {"mimeType", "image/png"}});
    builder.push("samplers", {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}});
    builder.push("textures", {{"source", 0}, {"sampler", 0}});
    builder.push("materials", material);
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    return builder;
}

TEST(GltfMaterial, DefaultsAreThoseOfTheFormat) {
    const assets::Model model = GltfBuilder::triangle().model();
    ASSERT_EQ(model.materials.size(), 1u);
    EXPECT_EQ(model.materials[0].baseColour, glm::vec4(1.0f));
    EXPECT_EQ(model.materials[0].metallic, 1.0f);
    EXPECT_EQ(model.materials[0].emissiveRadiance, glm::vec3(0.0f));
    EXPECT_EQ(model.nodes.at(0).primitives.at(0).material, 0u);
}

TEST(GltfMaterial, FactorsAndExtensionsAreRead) {
    const assets::Model model =
        textured({{"name", "paint"},
                  {"pbrMetallicRoughness",
                   {{"baseColorFactor", {0.1, 0.2, 0.3, 2}},
                    {"metallicFactor", 0.5},
                    {"roughnessFactor", 0.25}}},
                  {"emissiveFactor", {1, 0.5, 0}},
                  {"alphaMode", "MASK"},
                  {"alphaCutoff", 0.75},
                  {"doubleSided", true},
                  {"extensions",
                   {{"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}},
                    {"KHR_materials_specular",
                     {{"specularFactor", 0}, {"specularColorFactor", {1, 0.5, 0.25}}}}}}})
            .model();
    ASSERT_EQ(model.materials.size(), 1u);
    const assets::Material& material = model.materials[0];
    EXPECT_EQ(material.name, "paint");
    EXPECT_EQ(material.baseColour, glm::vec4(0.1f, 0.2f, 0.3f, 1.0f)) << "clamped to 1";
    EXPECT_EQ(material.metallic, 0.5f);
    EXPECT_EQ(material.roughness, 0.25f);
    EXPECT_EQ(material.emissiveRadiance, glm::vec3(8, 4, 0));
    EXPECT_EQ(material.alphaMode, assets::AlphaMode::Mask);
    EXPECT_EQ(material.alphaCutoff, 0.75f);
    EXPECT_TRUE(material.doubleSided);
    EXPECT_EQ(material.specularFactor, 0.0f);
    EXPECT_EQ(material.specularColour, glm::vec3(1, 0.5f, 0.25f));
    EXPECT_TRUE(model.images.empty()) << "no texture shows the image";
}

TEST(GltfMaterial, BlendIsAWarning) {
    const GltfBuilder builder = textured({{"name", "glass"}, {"alphaMode", "BLEND"}});
    EXPECT_EQ(logOf([&] { EXPECT_TRUE(builder.load()); }),
              "warning: test.gltf: /materials/0: material glass blends and is drawn opaque\n");
}

TEST(GltfMaterial, TexturesShareAnImageAndKeepTheirSampler) {
    const assets::Model model =
        textured(
            {{"pbrMetallicRoughness",
              {{"baseColorTexture", {{"index", 0}}}, {"metallicRoughnessTexture", {{"index", 0}}}}},
             {"emissiveTexture", {{"index", 0}}}})
            .model();
    const assets::Material& material = model.materials.at(0);
    ASSERT_EQ(model.images.size(), 1u);
    EXPECT_EQ(model.images[0].rgba, (std::vector<uint8_t>{1, 2, 3, 4}));
    EXPECT_EQ(material.baseColourTexture.image, 0);
    EXPECT_EQ(material.emissiveTexture.image, 0);
    EXPECT_FALSE(material.normalTexture.present());
    EXPECT_EQ(material.baseColourTexture.wrapU, assets::Wrap::Clamp);
    EXPECT_EQ(material.baseColourTexture.wrapV, assets::Wrap::Mirror);
    EXPECT_EQ(material.baseColourTexture.filter, assets::Filter::Nearest);
}

TEST(GltfMaterial, ANormalMapBringsTangents) {
    const GltfBuilder builder = textured({{"normalTexture", {{"index", 0}, {"scale", 0.5}}}});
    const assets::Model model = builder.model();
    EXPECT_EQ(model.materials.at(0).normalScale, 0.5f);
    EXPECT_EQ(model.meshes.at(0).tangents, std::vector<glm::vec4>(3, {1, 0, 0, -1}))
        << "v grows upwards here, so up the image is down";
    EXPECT_TRUE(
        textured({{"emissiveTexture", {{"index", 0}}}}).model().meshes.at(0).tangents.empty());
}

void expectNear(const std::vector<glm::vec2>& actual, const std::vector<glm::vec2>& expected) {
    ASSERT_EQ(actual.size(), expected.size());
    for (size_t i = 0; i < actual.size(); ++i)
        EXPECT_LT(glm::distance(actual[i], expected[i]), 1e-5f) << i;
}

Json transformed(float offset) {
    return {{"index", 0},
            {"extensions",
             {{"KHR_texture_transform",
               {{"offset", {offset, 0}}, {"scale", {2, 3}}, {"rotation", 1.57079632679}}}}}};
}

TEST(GltfMaterial, TextureTransformsGoIntoTheTextureCoordinates) {
    const assets::Model model =
        textured({{"pbrMetallicRoughness", {{"baseColorTexture", transformed(0.5f)}}},
                  {"emissiveTexture", {{"index", 0}}}})
            .model();
    EXPECT_EQ(model.materials.at(0).baseColourTexture.texcoordSet, 0u);
    EXPECT_EQ(model.materials.at(0).emissiveTexture.texcoordSet, 1u) << "the other slot";
    expectNear(model.meshes.at(0).texcoords0, {{0.5f, 0}, {0.5f, -2}, {3.5f, 0}});
    expectNear(model.meshes.at(0).texcoords1, {{0, 0}, {1, 0}, {0, 1}});
}

TEST(GltfMaterial, AThirdTextureTransformIsAWarning) {
    const GltfBuilder builder =
        textured({{"pbrMetallicRoughness", {{"baseColorTexture", transformed(0.5f)}}},
                  {"normalTexture", transformed(0.25f)},
                  {"emissiveTexture", {{"index", 0}}}});
    EXPECT_NE(logOf([&] { EXPECT_TRUE(builder.load()); }).find("more than two sets or transforms"),
              std::string::npos);
}

TEST(GltfMaterial, ATextureWithoutCoordinatesIsAWarning) {
    GltfBuilder builder = textured({{"emissiveTexture", {{"index", 0}, {"texCoord", 3}}}});
    EXPECT_NE(logOf([&] { EXPECT_TRUE(builder.load()); }).find("has no TEXCOORD_3"),
              std::string::npos);
    builder.addAttribute("TEXCOORD_3", 1);
    const assets::Model model = builder.model();
    EXPECT_EQ(model.meshes.at(0).texcoords0.at(1), glm::vec2(1, 0));
    EXPECT_EQ(model.materials.at(0).emissiveTexture.texcoordSet, 0u);
}

}  // namespace
}  // namespace lampyris::test
