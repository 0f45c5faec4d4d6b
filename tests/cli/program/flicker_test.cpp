// `lampyris flicker`: all figures of every pipeline, files beside them, one line for what cannot
// be.
#include <cmath>

#include "cli/program/program.h"
#include "core/file.h"
#include "core/image_io.h"

namespace lampyris::test {
namespace {

class Flicker : public testing::Test {
 protected:
    static Ran flicker(const Arguments& more, const std::string& scene = "cornell") {
        Arguments arguments{"flicker", scene,      "--size", "32x18", "--frames",
                            "4",       "--warmup", "2",      "--spp", "4"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return lampyris(arguments);
    }
    ScratchFolder folder_;
};

TEST_F(Flicker, PrintsEveryFigureOfEveryPipeline) {
    const Ran ran = flicker({});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    for (const char* word :
         {"32x18", "4 frames after 2", "static", "p99", "dynamic", "nothing moves", "floor",
          "lag off", "lag on", "lag moved", "MSSIM", "frozen", "\nfull ", "\nthesis ", "\ndirect "})
        EXPECT_NE(ran.out.find(word), std::string::npos) << word << " is not in\n" << ran.out;
}

TEST_F(Flicker, WritesFilesForPeopleAndPrograms) {
    const std::string map = folder_ / "map.png";
    const std::string out = folder_ / "out";
    const Ran ran =
        flicker({"--pipeline", "thesis", "--map", map, "--csv", folder_ / "a.csv", "--plot",
                 folder_ / "a.svg", "--report", folder_ / "a.json", "--out", out});
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.out.find("\nfull "), std::string::npos) << "one pipeline was asked for";
    const auto picture = core::readPng(map);
    ASSERT_TRUE(picture.ok()) << picture.error().message;
    EXPECT_EQ(picture->width, 32u);
    EXPECT_EQ(picture->height, 18u);
    const std::string csv = textOf(folder_ / "a.csv");
    EXPECT_TRUE(csv.starts_with("row,sequence,frame,value\n\"thesis\",still,0,0\n"));
    // Two sequences of 4 frames, three of 97, and the header.
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 4 + 3 * 97);
    EXPECT_NE(textOf(folder_ / "a.svg").find("light moved"), std::string::npos);
    EXPECT_NE(textOf(out + "/flicker.csv").find("thesis"), std::string::npos);
    const auto report = jsonOf(folder_ / "a.json");
    const auto& row = report["rows"][0];
    EXPECT_GT(row["static"]["mean"].get<double>(), 0.0);
    EXPECT_EQ(row["frozen"]["mean"].get<double>(), 0.0) << "the same paths, the same picture";
    EXPECT_EQ(row["settings"]["retrace"], "all");
    EXPECT_TRUE(row["dynamic"].is_null());
    EXPECT_EQ(row["lag"]["off"]["differences"].size(), 97u);
    EXPECT_EQ(row["lag"]["off"]["frames"], 1) << "there is nothing that could lag";
}

TEST_F(Flicker, IsTheSameEveryTimeAndKeepsReferences) {
    const Arguments call{"--pipeline", "thesis", "--out", folder_ / "out"};
    const Ran first = flicker(call);
    ASSERT_EQ(first.code, 0) << first.err;
    EXPECT_EQ(flicker(call).out, first.out);
    size_t references = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "out"))
        references += entry.path().extension() == ".exr" ? 1 : 0;
    EXPECT_EQ(references, 1u);
}

TEST_F(Flicker, NamesWhatIsMissing) {
    expectFailure(flicker({}, "nowhere"), "nowhere");
    expectFailure(flicker({"--map", folder_ / "no_folder/map.png"}), "no_folder");
    expectFailure(flicker({"--csv", folder_ / "no_folder/a.csv"}), "no_folder");
    expectFailure(flicker({"--reference", folder_ / "none.exr"}), "none.exr");
    ASSERT_TRUE(core::writeExr(folder_ / "small.exr", core::Image(8, 8, 3)).ok());
    expectFailure(flicker({"--reference", folder_ / "small.exr"}), "small.exr: is 8x8");
    expectFailure(lampyris({"flicker", "cornell", "--size", "8x8"}), "MSSIM needs 11x11");
    expectFailure(flicker({"--out", folder_ / "small.exr"}), "small.exr");
}

TEST_F(Flicker, RefusesWrongCalls) {
    const std::vector<std::pair<Arguments, std::string>> calls{
        {{"--reseed", "off"}, "--reseed"},
        {{"--map", "map.exr"}, ".png"},
        {{"--csv", "a.txt"}, ".csv"},
        {{"--plot", "a.png"}, ".svg"},
        {{"--report", "a.txt"}, ".json"},
        {{"--sweep", "--photons", "3"}, "--sweep"},
        {{"--sweep", "--map", "map.png"}, "--map"},
        {{"--sweep", "--pipeline", "direct"}, "--sweep"},
        {{"--pipeline", "thesis", "--max-bounces", "2"}, "one bounce"},
        {{"--output-node", "direct"}, "--output-node"},
        {{"--timestep", "-1"}, "--timestep"}};
    for (const auto& [more, what] : calls) {
        SCOPED_TRACE(testing::PrintToString(more));
        expectWrongCall(flicker(more), what);
    }
    expectWrongCall(lampyris({"flicker"}), "scene");
    expectWrongCall(lampyris({"flicker", "cornell", "--frames", "1"}), "--frames");
    EXPECT_EQ(lampyris({"flicker", "--help"}).code, 0);
}

}  // namespace
}  // namespace lampyris::test
