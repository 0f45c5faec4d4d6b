// Files and devices that are not what they should be: exit 1 with one line that names the file and
// what is wrong, or what is left of the scene with a warning. Never a crash, a hang, or a black
// picture in silence.
#include <algorithm>
#include <cmath>
#include <limits>

#include "cli/program/program.h"
#include "core/file.h"
#include "core/image_io.h"
#include "support/gltf_builder.h"

namespace lampyris::test {
namespace {

class BadInput : public testing::Test {
 protected:
    std::string write(const std::string& name, const std::vector<uint8_t>& bytes) {
        const auto path = folder_ / name;
        EXPECT_TRUE(core::writeFile(path, std::span<const uint8_t>(bytes)).ok());
        return path.string();
    }
    std::string write(const std::string& name, const GltfBuilder& builder) {
        return write(name, builder.gltf());
    }
    /// Rendering it ends with exit 1, and a line that names the file and `what`; no file is left.
    void expectRefused(const std::string& file, const std::string& what) {
        SCOPED_TRACE(file);
        const size_t before = folder_.files();
        const Ran ran = render(file, folder_ / "picture.png");
        expectFailure(ran, what);
        EXPECT_NE(ran.err.find(file), std::string::npos) << ran.err;
        EXPECT_EQ(folder_.files(), before) << "a picture, or a part of one";
    }
    /// Rendering it gives a picture that is not black, and a warning that holds `what`.
    void expectDrawn(const std::string& file, const std::string& what) {
        SCOPED_TRACE(file);
        const Ran ran = render(file, folder_ / "picture.exr");
        ASSERT_EQ(ran.code, 0) << "signal " << ran.signal << "\n" << ran.err;
        EXPECT_NE(ran.err.find("warning: "), std::string::npos) << ran.err;
        EXPECT_NE(ran.err.find(what), std::string::npos) << "no '" << what << "' in: " << ran.err;
        const auto image = core::readExr(folder_ / "picture.exr");
        ASSERT_TRUE(image.ok());
        const auto& values = image.value().values;
        EXPECT_GT(*std::max_element(values.begin(), values.end()), 0.0f);
        EXPECT_TRUE(
            std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); }));
    }
    ScratchFolder folder_;
};

TEST_F(BadInput, MissingAndForeignFiles) {
    expectRefused((folder_ / "missing.glb").string(), "No such file");
    std::filesystem::create_directory(folder_ / "folder.gltf");
    expectRefused((folder_ / "folder.gltf").string(), "folder");
    expectRefused(write("empty.glb", std::vector<uint8_t>{}), "");
    expectRefused(write("empty.gltf", std::vector<uint8_t>{}), "");
    expectRefused(write("noise.glb", std::vector<uint8_t>(1000, 0xa5)), "");
    const std::string text = "this is a letter";
    expectRefused(write("letter.gltf", std::vector<uint8_t>(text.begin(), text.end())), "");
}

TEST_F(BadInput, FilesCutAtAnyPlace) {
    const std::vector<uint8_t> whole = GltfBuilder::floor().glb();
    for (const size_t length :
         {size_t{3}, size_t{12}, size_t{19}, size_t{40}, whole.size() / 2, whole.size() - 4})
        expectRefused(
            write("cut.glb", {whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)}),
            "");
    const std::vector<uint8_t> text = GltfBuilder::floor().gltf();
    for (const size_t length : {size_t{1}, text.size() / 2, text.size() - 1})
        expectRefused(
            write("cut.gltf", {text.begin(), text.begin() + static_cast<std::ptrdiff_t>(length)}),
            "");
}

TEST_F(BadInput, RangesOutsideTheirData) {
    const auto bent = [&](const std::string& name, const std::string& what, const auto& bend) {
        GltfBuilder builder = GltfBuilder::floor();
        bend(builder);
        expectRefused(write(name + ".gltf", builder), what);
    };
    bent("view", "/bufferViews/0",
         [](GltfBuilder& b) { b.json["bufferViews"][0]["byteLength"] = 100000; });
    bent("offset", "/bufferViews/0",
         [](GltfBuilder& b) { b.json["bufferViews"][0]["byteOffset"] = 4000000000u; });
    bent("accessor", "/accessors/0",
         [](GltfBuilder& b) { b.json["accessors"][0]["count"] = 4000000000u; });
    bent("sparse", "sparse", [](GltfBuilder& b) {
        b.json["accessors"][0]["sparse"] = {
            {"count", 900},
            {"indices", {{"bufferView", 0}, {"componentType", kUint}}},
            {"values", {{"bufferView", 0}}}};
    });
    bent("no_view", "bufferView",
         [](GltfBuilder& b) { b.json["accessors"][0]["bufferView"] = 77; });
    bent("buffer", "/buffers/0", [](GltfBuilder& b) {
        b.json["buffers"] = {
            {{"byteLength", 1000}, {"uri", "data:application/octet-stream;base64,AAAA"}}};
    });
    bent("beside", "nowhere.bin", [](GltfBuilder& b) {
        b.json["buffers"] = {{{"byteLength", 1000}, {"uri", "nowhere.bin"}}};
    });
    bent("image", "/images/0", [](GltfBuilder& b) {
        b.push("images", {{"bufferView", 55}, {"mimeType", "image/png"}});
    });
}

TEST_F(BadInput, NothingThatCouldBeDrawn) {
    GltfBuilder empty;
    expectRefused(write("empty.gltf", empty), "mesh");
    const float nan = std::numeric_limits<float>::quiet_NaN();
    expectRefused(write("nan.gltf", GltfBuilder::floor(std::vector<float>(12, nan))), "NaN");
    expectRefused(write("point.gltf", GltfBuilder::floor(std::vector<float>(12, 1.0f))),
                  "without area");
}

TEST_F(BadInput, WhatIsLeftIsDrawn) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    expectDrawn(write("nan.gltf", GltfBuilder::floor({-1, 0, -1, 1, 0, -1, 1, 0, 1, nan, 0, 1})),
                "NaN or infinity");
    expectDrawn(write("inf.gltf", GltfBuilder::floor({-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, inf})),
                "NaN or infinity");
    expectDrawn(write("thin.gltf", GltfBuilder::floor({-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, -1})),
                "triangle");
    expectDrawn(write("plain.gltf", GltfBuilder::floor()), "camera");
    GltfBuilder flattened = GltfBuilder::floor();
    const int gone = flattened.push("nodes", {{"mesh", 0}, {"scale", {0, 0, 0}}});
    flattened.json["scenes"][0]["nodes"].push_back(gone);
    expectDrawn(write("flattened.gltf", flattened), "1 meshes have no extent");
    expectDrawn(write("dark.gltf", GltfBuilder::floor()), "light");
    GltfBuilder sun = GltfBuilder::floor();
    sun.addLight({{"type", "directional"}, {"intensity", 3.0}});
    expectDrawn(write("sun.gltf", sun), "directional");
}

TEST_F(BadInput, NamesThatAreNotThere) {
    const std::string picture = folder_ / "picture.png";
    expectFailure(render("no_such_scene", picture), "cornell");
    expectFailure(render("cornell", picture, {"--camera", "no such camera"}), "no such camera");
    expectFailure(render("cornell", picture, {"--output-node", "no_such_image"}), "albedo");
    expectFailure(render("cornell", picture, {"--device", "no such device"}), "no such device");
    EXPECT_EQ(folder_.files(), 0u);
}

TEST_F(BadInput, PlacesThatCannotBeWritten) {
    const std::string picture = folder_ / "picture.png";
    expectFailure(render("cornell", folder_ / "no_folder/a.png"), "no_folder");
    expectFailure(render("cornell", picture, {"--report", folder_ / "no_folder/a.json"}),
                  "no_folder");
    expectFailure(render("cornell", picture, {"--graph", folder_ / "no_folder/a.dot"}),
                  "no_folder");
    expectFailure(render("cornell", picture, {"--trace", folder_ / "no_folder/a.json"}),
                  "no_folder");
    std::filesystem::create_directory(folder_ / "taken.png");
    expectFailure(render("cornell", folder_ / "taken.png"), "taken.png");
    EXPECT_EQ(folder_.files(), 1u);
}

TEST_F(BadInput, MoreThanTheDeviceHolds) {
    const std::string picture = folder_ / "picture.png";
    expectFailure(render("cornell", picture, {"--photons", "4294967295"}), "--photons");
    expectFailure(render("cornell", picture, {"--size", "65535x65535"}), "65535");
    EXPECT_EQ(folder_.files(), 0u);
    // 31 shadow rays take five layers for 32 lights: 9375, and devices have 2048 or 8192.
    GltfBuilder lights = GltfBuilder::floor();
    lights.addLight({{"type", "point"}, {"intensity", 1.0}}, 60000);
    const Ran ran = render(write("lights.gltf", lights), picture, {"--shadow-rays", "31"});
    expectFailure(ran, "60000 lights");
    expectFailure(ran, "maxImageArrayLayers");
    EXPECT_EQ(folder_.files(), 1u);
}

TEST_F(BadInput, ValidationLayerThatIsMissing) {
    const Ran ran =
        lampyris({"info", "--validation"},
                 {"VK_LAYER_PATH=/nowhere", "XDG_DATA_DIRS=/nowhere", "XDG_CONFIG_DIRS=/nowhere"});
    expectFailure(ran, "VK_LAYER_KHRONOS_validation");
}

}  // namespace
}  // namespace lampyris::test
