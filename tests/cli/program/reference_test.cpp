// `lampyris reference`: the picture, its parts and its report; one line for what cannot be had.
#include <algorithm>

#include "cli/program/program.h"
#include "core/file.h"
#include "core/image_io.h"
#include "reference/reference.h"
#include "support/gltf_builder.h"

namespace lampyris::test {
namespace {

class Reference : public testing::Test {
 protected:
    /// At 32x18 with 4 samples a pixel, unless `more` says otherwise.
    Ran reference(const std::string& scene, const std::string& picture,
                  const Arguments& more = {}) {
        Arguments arguments{"reference", scene, "-o", folder_ / picture};
        const auto unlessAsked = [&](const char* option, const char* value) {
            if (std::find(more.begin(), more.end(), option) == more.end())
                arguments.insert(arguments.end(), {option, value});
        };
        unlessAsked("--size", "32x18");
        unlessAsked("--spp", "4");
        arguments.insert(arguments.end(), more.begin(), more.end());
        return lampyris(arguments);
    }
    core::Image image(const std::string& name) {
        auto read = core::readExr(folder_ / name);
        EXPECT_TRUE(read.ok()) << name;
        return read.ok() ? std::move(read).value() : core::Image{};
    }
    std::string bytes(const std::string& name) { return textOf(folder_ / name); }
    ScratchFolder folder_;
};

double meanOf(const core::Image& image) {
    double sum = 0.0;
    for (const float value : image.values) sum += static_cast<double>(value);
    return sum / static_cast<double>(image.values.size());
}

TEST_F(Reference, WritesThePictureAndSaysNothing) {
    const Ran ran = reference("cornell", "a.exr");
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.out + ran.err, "") << "no progress in a pipe";
    EXPECT_EQ(image("a.exr").width, 32u);
    EXPECT_GT(meanOf(image("a.exr")), 0.1);
    ASSERT_EQ(reference("cornell", "b.exr", {"--threads", "3"}).code, 0);
    EXPECT_TRUE(bytes("a.exr") == bytes("b.exr")) << "same seed, same bytes";
    ASSERT_EQ(reference("cornell", "b.exr", {"--seed", "2"}).code, 0);
    EXPECT_FALSE(bytes("a.exr") == bytes("b.exr"));
    EXPECT_EQ(reference("cornell", "c.png", {"--exposure", "-1"}).code, 0);
    EXPECT_TRUE(core::readPng(folder_ / "c.png").ok());
}

TEST_F(Reference, WritesEveryImageAloneOrAllAtOnce) {
    ASSERT_EQ(reference("cornell", "a.exr", {"--all", folder_ / "all"}).code, 0);
    for (const std::string_view shown : reference::kImageNames) {
        const std::string name(shown);
        SCOPED_TRACE(name);
        const Ran ran = reference("cornell", name + ".exr", {"--output-node", name});
        EXPECT_EQ(ran.code, 0) << ran.err;
        EXPECT_TRUE(bytes(name + ".exr") == bytes("all/" + name + ".exr"));
        EXPECT_NE(meanOf(image(name + ".exr")), 0.0);
    }
    const core::Image direct = image("direct.exr"), indirect = image("indirect.exr");
    const core::Image sum = image("final.exr");
    const size_t floor = 3 * (16 * 32 + 16);  // no light's disc there
    EXPECT_NEAR(direct.values[floor] + indirect.values[floor], sum.values[floor], 1e-5f);
    expectFailure(reference("cornell", "b.exr", {"--output-node", "edges"}), "albedo");
}

TEST_F(Reference, HasAsManyBouncesAsAreAskedFor) {
    double last = -1.0;
    for (const char* bounces : {"0", "1", "4"}) {
        ASSERT_EQ(
            reference("cornell", "a.exr", {"--max-bounces", bounces, "--output-node", "indirect"})
                .code,
            0);
        const double light = meanOf(image("a.exr"));
        EXPECT_GT(light, last);
        if (bounces == std::string("0")) {
            EXPECT_EQ(light, 0.0);
        }
        last = light;
    }
}

TEST_F(Reference, ReportsWhatItDid) {
    const std::string report = folder_ / "report.json";
    const Ran ran = reference("two_rooms", "a.exr",
                              {"--report", report, "--spp", "4096", "--max-error", "0.5"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    const auto json = jsonOf(report);
    EXPECT_EQ(json["scene"], "two_rooms");
    EXPECT_EQ(json["size"], Json::array({32, 18}));
    EXPECT_EQ(json["settings"]["spp"], 4096);
    EXPECT_TRUE(json["settings"]["max_bounces"].is_null());
    EXPECT_LT(json["spp"], 4096) << "the error was small enough";
    EXPECT_LE(json["error"], 0.5);
    EXPECT_GT(json["rays"], 32 * 18 * json["spp"].get<int>());
    EXPECT_NEAR(json["rays_per_second"].get<double>() * json["seconds"].get<double>(),
                json["rays"].get<double>(), 1.0);
}

TEST_F(Reference, LightsWithoutPowerGiveBlackAndAWord) {
    GltfBuilder builder = GltfBuilder::floor();
    builder.addLight({{"type", "point"}, {"intensity", 0.0}});
    const std::vector<uint8_t> bytes = builder.gltf();
    const std::string file = folder_ / "dark.gltf";
    ASSERT_TRUE(core::writeFile(file, std::span<const uint8_t>(bytes)).ok());
    for (const char* call : {"reference", "render"}) {
        const Ran ran = lampyris({call, file, "-o", folder_ / "a.exr", "--size", "32x18"});
        EXPECT_EQ(ran.code, 0) << ran.err;
        EXPECT_NE(ran.err.find("dark.gltf: its lights have no power"), std::string::npos)
            << ran.err;
        EXPECT_EQ(meanOf(image("a.exr")), 0.0) << call;
    }
}

TEST_F(Reference, NamesWhatCannotBeHad) {
    expectFailure(reference("cornell", "a.exr", {"--spp", "0"}), "--spp 0");
    expectFailure(reference("cornell", "a.exr", {"--camera", "nobody"}), "--camera nobody");
    expectFailure(reference("cornell", "a.exr", {"--animation", "none"}), "--animation none");
    expectFailure(reference("no_such_scene", "a.exr"), "cornell");
    expectFailure(reference(folder_ / "missing.glb", "a.exr"), "missing.glb");
    expectFailure(reference("cornell", "no_folder/a.exr"), "no_folder");
    expectFailure(reference("cornell", "a.exr", {"--report", folder_ / "no_folder/r.json"}),
                  "no_folder");
    expectFailure(reference("cornell", "a.exr", {"--all", folder_ / "no/folder"}), "no/folder");
    expectFailure(reference("cornell", "a.exr", {"--size", "65535x65535"}), "65535x65535");
    EXPECT_EQ(folder_.files(), 0u);
}

TEST_F(Reference, RefusesWrongCalls) {
    expectWrongCall(reference("cornell", "a.exr", {"--spp", "-1"}), "--spp");
    expectWrongCall(reference("cornell", "a.exr", {"--spp", "many"}), "--spp");
    expectWrongCall(reference("cornell", "a.exr", {"--max-error", "0"}), "--max-error");
    expectWrongCall(reference("cornell", "a.exr", {"--max-error", "nan"}), "--max-error");
    expectWrongCall(reference("cornell", "a.exr", {"--max-bounces", "-1"}), "--max-bounces");
    expectWrongCall(reference("cornell", "a.exr", {"--transport", "glossy"}), "glossy");
    expectWrongCall(reference("cornell", "a.exr", {"--photons", "50"}), "--photons");
    expectWrongCall(reference("cornell", "a.jpg"), ".png or .exr");
    EXPECT_EQ(lampyris({"reference", "--help"}).code, 0);
    EXPECT_EQ(folder_.files(), 0u);
}

}  // namespace
}  // namespace lampyris::test
