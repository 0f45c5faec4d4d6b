// `lampyris render`: what it writes, and that the same call gives the same bytes.
#include <algorithm>
#include <cmath>

#include "cli/program/program.h"
#include "core/image_io.h"

namespace lampyris::test {
namespace {

core::Image exr(const std::filesystem::path& path) {
    auto image = core::readExr(path);
    EXPECT_TRUE(image.ok());
    return image.ok() ? std::move(image).value() : core::Image(1, 1, 3);
}

double meanOf(const core::Image& image) {
    double sum = 0.0;
    for (const float value : image.values) sum += value;
    return sum / static_cast<double>(image.values.size());
}

TEST(Render, WritesLinearRadianceAsExr) {
    const ScratchFolder folder;
    const Ran ran = render("cornell", folder / "a.exr");
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.out + ran.err, "") << "nothing in a pipe";
    const core::Image image = exr(folder / "a.exr");
    EXPECT_EQ(image.width, 160u);
    EXPECT_EQ(image.height, 90u);
    EXPECT_GT(*std::max_element(image.values.begin(), image.values.end()), 1.0f);
    EXPECT_TRUE(std::all_of(image.values.begin(), image.values.end(),
                            [](float v) { return std::isfinite(v) && v >= 0.0f; }));
    for (uint32_t c = 0; c < 3; ++c) EXPECT_EQ(image.at(0, 45, c), 0.0f) << "background";
    EXPECT_EQ(folder.files(), 1u);
}

TEST(Render, WritesDisplayValuesAsPng) {
    const ScratchFolder folder;
    ASSERT_EQ(render("cornell", folder / "a.png").code, 0);
    ASSERT_EQ(render("cornell", folder / "dark.png", {"--exposure", "-3"}).code, 0);
    ASSERT_EQ(render("cornell", folder / "filmic.png", {"--tonemap", "filmic"}).code, 0);
    const auto picture = core::readPng(folder / "a.png");
    ASSERT_TRUE(picture.ok());
    EXPECT_EQ(picture.value().width, 160u);
    EXPECT_EQ(picture.value().height, 90u);
    const auto dark = core::readPng(folder / "dark.png");
    ASSERT_TRUE(dark.ok());
    EXPECT_LT(dark.value().values[(45 * 160 + 80) * 3],
              picture.value().values[(45 * 160 + 80) * 3]);
    EXPECT_NE(textOf(folder / "filmic.png"), textOf(folder / "a.png"));
}

TEST(Render, GivesTheSameBytesWhateverTheThreads) {
    const ScratchFolder folder;
    const Arguments call{"render", "cornell", "--size", "160x90", "--frames", "2", "-o"};
    const auto renderTo = [&](const std::string& name, const std::string& threads) {
        Arguments arguments = call;
        arguments.push_back(folder / name);
        ASSERT_EQ(lampyris(arguments, {"LP_NUM_THREADS=" + threads}).code, 0);
    };
    renderTo("a.exr", "0");
    renderTo("b.exr", "2");
    renderTo("c.exr", "5");
    EXPECT_EQ(textOf(folder / "a.exr"), textOf(folder / "b.exr"));
    EXPECT_EQ(textOf(folder / "a.exr"), textOf(folder / "c.exr"));
}

TEST(Render, DrawsPathsFromTheSeedAndTheFrame) {
    const ScratchFolder folder;
    const auto bytes = [&](const std::string& name, const Arguments& more) {
        EXPECT_EQ(render("cornell", folder / name, more).code, 0);
        return textOf(folder / name);
    };
    const std::string first = bytes("a.exr", {"--pipeline", "thesis"});
    EXPECT_NE(first, bytes("b.exr", {"--pipeline", "thesis", "--seed", "2"}));
    EXPECT_NE(first, bytes("c.exr", {"--pipeline", "thesis", "--warmup", "1"}));
    const Arguments frozen{"--pipeline", "thesis", "--reseed", "off"};
    Arguments frozenLater = frozen;
    frozenLater.insert(frozenLater.end(), {"--warmup", "3"});
    EXPECT_EQ(bytes("d.exr", frozen), bytes("e.exr", frozenLater));
}

TEST(Render, PipelinesDiffer) {
    const ScratchFolder folder;
    for (const char* pipeline : {"full", "thesis", "direct"})
        ASSERT_EQ(
            render("cornell", folder / (std::string(pipeline) + ".exr"), {"--pipeline", pipeline})
                .code,
            0);
    const double direct = meanOf(exr(folder / "direct.exr"));
    EXPECT_GT(meanOf(exr(folder / "full.exr")), 1.1 * direct);
    EXPECT_NE(textOf(folder / "full.exr"), textOf(folder / "thesis.exr"));
    // No photon is asked for: direct light alone.
    ASSERT_EQ(render("cornell", folder / "none.exr", {"--max-bounces", "0"}).code, 0);
    EXPECT_EQ(textOf(folder / "none.exr"), textOf(folder / "direct.exr"));
}

TEST(Render, WritesAnyImageOfTheGraph) {
    const ScratchFolder folder;
    const auto image = [&](const std::string& name) {
        EXPECT_EQ(render("cornell", folder / (name + ".exr"), {"--output-node", name}).code, 0)
            << name;
        return exr(folder / (name + ".exr"));
    };
    const core::Image albedo = image("albedo");  // the left wall stands at the picture's left
    EXPECT_NEAR(albedo.at(45, 45, 0), 0.63f, 0.01f);
    EXPECT_NEAR(albedo.at(45, 45, 1), 0.065f, 0.01f);
    const core::Image normal = image("normal");
    EXPECT_NEAR(normal.at(45, 45, 0), 1.0f, 0.01f);
    const core::Image position = image("position");
    EXPECT_NEAR(position.at(45, 45, 0), -5.0f, 0.01f);
    const core::Image direct = image("direct"), indirect = image("indirect"),
                      whole = image("final");
    for (uint32_t c = 0; c < 3; ++c)
        EXPECT_NEAR(direct.at(45, 60, c) + indirect.at(45, 60, c), whole.at(45, 60, c),
                    0.01f * whole.at(45, 60, c) + 1e-4f);
    EXPECT_GT(meanOf(image("irradiance_direct")), meanOf(direct));
    EXPECT_GT(meanOf(image("irradiance_indirect")), meanOf(indirect));
    EXPECT_GT(meanOf(image("depth")), 0.0);
    EXPECT_GT(meanOf(image("edges")), 0.0);
}

TEST(Render, WritesBlackForLightThatThePipelineLacks) {
    const ScratchFolder folder;
    for (const Arguments& without : {Arguments{"--pipeline", "direct"}, {"--max-bounces", "0"}})
        for (const std::string name : {"indirect", "irradiance_indirect", "edges"}) {
            Arguments arguments{"--output-node", name};
            arguments.insert(arguments.end(), without.begin(), without.end());
            ASSERT_EQ(render("cornell", folder / "a.exr", arguments).code, 0) << name;
            EXPECT_EQ(meanOf(exr(folder / "a.exr")), 0.0) << name;
        }
}

TEST(Render, RepeatsAFrameThatOverflowed) {
    const ScratchFolder folder;
    // Every photon reaches every tile: far more entries than the first guess.
    const Ran ran =
        render("cornell", folder / "a.png",
               {"--gather", "tiles", "--radius", "100", "--gather-divisor", "8", "--photons", "300",
                "--size", "640x360", "--report", folder / "a.json"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    const auto report = jsonOf(folder / "a.json");
    EXPECT_TRUE(report["valid"].get<bool>());
    EXPECT_EQ(report["tiles"]["dropped"], 0);
    EXPECT_EQ(report["photons"]["dropped"], 0);
    const int64_t tiles = 80 * 45;
    EXPECT_GT(report["tiles"]["pairs"].get<int64_t>(),
              64 * report["photons"]["stored"].get<int64_t>())
        << "of " << tiles << " tiles; the first guess would have been enough";
}

TEST(Render, DrawsTheSceneThatTheRepositoryShips) {
    const ScratchFolder folder;
    const Ran ran = render(LAMPYRIS_SOURCE_DIR "/sandbox/scenes/gallery.gltf", folder / "a.exr");
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    EXPECT_GT(meanOf(exr(folder / "a.exr")), 0.01);
}

TEST(Render, PassesValidation) {
    const ScratchFolder folder;
    for (const char* pipeline : {"full", "thesis"}) {
        const Ran ran = render("cornell", folder / "a.png",
                               {"--validation", "--pipeline", pipeline, "--frames", "2", "--report",
                                folder / "a.json"});
        ASSERT_EQ(ran.code, 0) << ran.err;
        EXPECT_EQ(ran.err, "");
        const auto report = jsonOf(folder / "a.json");
        EXPECT_EQ(report["validation"], "core+sync");
        EXPECT_EQ(report["validation_messages"], 0);
    }
}

TEST(Render, PrintsATableOfNodesWhenAsked) {
    const ScratchFolder folder;
    const Ran ran = render("cornell", folder / "a.png", {"--table"});
    ASSERT_EQ(ran.code, 0) << ran.err;
    for (const char* row :
         {"gbuffer", "photon_trace", "irradiance_grid", "gather", "upsample", "frame"})
        EXPECT_NE(ran.out.find(std::string("\n") + row + " "), std::string::npos) << ran.out;
}

}  // namespace
}  // namespace lampyris::test
