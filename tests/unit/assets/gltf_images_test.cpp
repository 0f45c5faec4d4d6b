#include <gtest/gtest.h>

#include <filesystem>

#include "core/file.h"
#include "support/gltf_builder.h"
#include "support/png_bytes.h"

namespace lampyris::test {
namespace {

namespace fs = std::filesystem;

/// A triangle whose base colour is image 0.
GltfBuilder showing(const Json& image) {
    GltfBuilder builder = GltfBuilder::triangle();
    builder.addAttribute("TEXCOORD_0", builder.addFloats({0, 0, 1, 0, 0, 1}, "VEC2"));
    builder.push("images", image);
    builder.push("textures", {{"source", 0}});
    builder.push("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    return builder;
}

std::string dataUri(const std::vector<uint8_t>& bytes) {
    return "data:image/png;base64," + base64(bytes);
}

TEST(GltfImages, ADataUriIsDecoded) {
    const assets::Model model =
        showing({{"name", "dots"}, {"uri", dataUri(pngBytes(2, 1, {9, 8, 7, 6, 5, 4, 3, 2}))}})
            .model();
    ASSERT_EQ(model.images.size(), 1u);
    EXPECT_EQ(model.images[0].name, "dots");
    EXPECT_EQ(model.images[0].width, 2u);
    EXPECT_EQ(model.images[0].height, 1u);
    EXPECT_EQ(model.images[0].rgba, (std::vector<uint8_t>{9, 8, 7, 6, 5, 4, 3, 2}));
}

TEST(GltfImages, SixteenBitsComeDownToEight) {
    const assets::Model model =
        showing({{"uri", dataUri(pngBytes(1, 1, {0x1234, 0x80ff, 0, 0xffff}, 16))}}).model();
    ASSERT_EQ(model.images.size(), 1u);
    EXPECT_EQ(model.images[0].rgba, (std::vector<uint8_t>{0x12, 0x80, 0, 0xff}));
}

TEST(GltfImages, BrokenPixelsAreAWarningAndNoTexture) {
    std::vector<uint8_t> cut = pngBytes(2, 1, {9, 8, 7, 6, 5, 4, 3, 2});
    cut.resize(45);
    const std::vector<uint8_t> noImage = {'G', 'I', 'F', '8', '9', 'a', 0, 0};
    for (const std::vector<uint8_t>& bytes : {cut, noImage}) {
        const GltfBuilder builder = showing({{"uri", dataUri(bytes)}});
        assets::Model model;
        EXPECT_NE(logOf([&] { model = builder.model(); }).find("what shows it goes without"),
                  std::string::npos);
        EXPECT_TRUE(model.images.empty());
        EXPECT_FALSE(model.materials.at(0).baseColourTexture.present());
    }
}

TEST(GltfImages, AbsurdSizesAreAnErrorBeforeAnyPixelIsRead) {
    const std::vector<uint8_t> huge = pngBytes(20000, 1, {});
    EXPECT_EQ(showing({{"uri", dataUri(huge)}}).error(),
              "test.gltf: /images/0: has 20000x1 texels; the limit is 16384 a side");
    const std::vector<uint8_t> many = pngBytes(16000, 16000, {});
    const auto result = assets::parseGltf(showing({{"uri", dataUri(many)}}).gltf(), "test.gltf", {},
                                          {.decodedBytes = 1000000});
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find("/images/0: needs 1024000000 bytes more"),
              std::string::npos);
}

TEST(GltfImages, AFileThatIsMissingIsAnErrorThatNamesIt) {
    const auto result = assets::parseGltf(showing({{"uri", "no%20such.png"}}).gltf(), "test.gltf",
                                          fs::path("/nowhere"));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().message, "test.gltf: /images/0/uri: /nowhere/no such.png is missing");
}

TEST(GltfImages, AFileBesideIsRead) {
    const fs::path folder = fs::path(LAMPYRIS_BINARY_DIR) / "gltf_images_test";
    fs::create_directories(folder);
    ASSERT_TRUE(core::writeFile(folder / "a b.png", pngBytes(1, 1, {1, 2, 3, 4})));
    ASSERT_TRUE(core::writeFile(folder / "scene.gltf", showing({{"uri", "a%20b.png"}}).gltf()));
    const auto model = assets::loadGltf(folder / "scene.gltf");
    ASSERT_TRUE(model) << model.error().message;
    EXPECT_EQ(model->images.at(0).rgba, (std::vector<uint8_t>{1, 2, 3, 4}));
    EXPECT_EQ(model->name, "scene.gltf");
    fs::remove_all(folder);
}

}  // namespace
}  // namespace lampyris::test
