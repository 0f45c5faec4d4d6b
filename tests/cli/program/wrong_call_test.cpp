// Calls that cannot be served: exit 2, one line, nothing written.
#include "cli/program/program.h"

namespace lampyris::test {
namespace {

TEST(WrongCall, NamesWhatIsWrong) {
    expectWrongCall(lampyris({}), "subcommand");
    expectWrongCall(lampyris({"paint"}), "paint");
    expectWrongCall(lampyris({"reference", "cornell"}), "--output");
    expectWrongCall(lampyris({"render"}), "scene");
    expectWrongCall(lampyris({"render", "cornell"}), "--output");
    expectWrongCall(lampyris({"bench"}), "name");
    expectWrongCall(lampyris({"bench", "nothing"}), "nothing");
    expectWrongCall(lampyris({"info", "--size", "1x1"}), "--size");
    expectWrongCall(lampyris({"bench", "binning", "--photons", "50"}), "--photons");
    expectWrongCall(lampyris({"bench", "nodes", "--pipeline", "direct"}), "--pipeline");
    expectWrongCall(lampyris({"bench", "nodes", "--spp", "4"}), "--spp");
    expectWrongCall(lampyris({"bench", "binning", "--gather-rays", "4"}), "--gather-rays");
    expectWrongCall(lampyris({"bench", "rays", "--shadow-rays", "4"}), "--shadow-rays");
    expectWrongCall(lampyris({"bench", "motion", "--retrace", "all"}), "--retrace");
    expectWrongCall(lampyris({"bench", "soak", "--scene", "cornell"}), "--scene");
    expectWrongCall(lampyris({"bench", "parameter-scaling", "--radius", "1"}), "--radius");
    expectWrongCall(lampyris({"bench", "scene-complexity", "--reference", "a.exr"}), "--reference");
}

TEST(WrongCall, BudgetsAreOfViewsFinalGather) {
    expectWrongCall(lampyris({"render", "cornell", "-o", "a.png", "--budget-ms", "9"}),
                    "--budget-ms");
    expectWrongCall(lampyris({"bench", "budget", "--budget-ms", "9"}), "--budget-ms");
    for (const char* milliseconds : {"0", "-1", "nan", "fast"})
        expectWrongCall(lampyris({"view", "cornell", "--budget-ms", milliseconds}), "--budget-ms");
    for (const Arguments& more : {Arguments{"--pipeline", "thesis"},
                                  {"--pipeline", "direct"},
                                  {"--gather", "tiles"},
                                  {"--max-bounces", "0"},
                                  {"--replay", "a.log"}}) {
        Arguments arguments{"view", "cornell", "--budget-ms", "9"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        expectWrongCall(lampyris(arguments), "--budget-ms");
    }
    expectWrongCall(lampyris({"render", "cornell", "-o", "a.png", "--shaders", "off"}),
                    "--shaders");
}

TEST(WrongCall, NoFileIsForTwoThings) {
    for (const Arguments& more : {Arguments{"--settings", "a.json", "--record", "a.json"},
                                  {"--settings", "./a.json", "--report", "a.json"},
                                  {"--flicker", "a", "--record", "a"},
                                  {"--settings", "a", "--replay", "a"}}) {
        Arguments arguments{"view", "cornell"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        expectWrongCall(lampyris(arguments), "asked for twice");
    }
    EXPECT_FALSE(std::filesystem::exists("a.json"));
}

TEST(WrongCall, LeavesNoFile) {
    const ScratchFolder folder;
    const std::vector<std::pair<Arguments, std::string>> calls{
        {{"--size", "0x90"}, "0x90"},
        {{"--size", "160x0"}, "160x0"},
        {{"--size", "160"}, "160"},
        {{"--size", "-1x90"}, "-1x90"},
        {{"--size", "99999999999x90"}, "99999999999x90"},
        {{"--size", "big"}, "big"},
        {{"--size", "160x90x2"}, "160x90x2"},
        {{"--frames", "0"}, "--frames"},
        {{"--frames", "many"}, "--frames"},
        {{"--warmup", "-1"}, "--warmup"},
        {{"--photons", "0"}, "--photons"},
        {{"--photons", "-5"}, "--photons"},
        {{"--photons", "99999999999"}, "--photons"},
        {{"--radius", "0"}, "--radius"},
        {{"--radius", "-1"}, "--radius"},
        {{"--radius", "nan"}, "--radius"},
        {{"--radius", "inf"}, "--radius"},
        {{"--gather-divisor", "0"}, "--gather-divisor"},
        {{"--max-bounces", "-1"}, "--max-bounces"},
        {{"--max-bounces", "100000"}, "--max-bounces"},
        {{"--pipeline", "fast"}, "fast"},
        {{"--quality", "best"}, "best"},
        {{"--gather", "both"}, "both"},
        {{"--gather", "final", "--pipeline", "thesis"}, "needs full"},
        {{"--gather-rays", "0"}, "--gather-rays"},
        {{"--shadow-rays", "32"}, "--shadow-rays"},
        {{"--shadow-divisor", "0"}, "--shadow-divisor"},
        {{"--filter-levels", "9"}, "--filter-levels"},
        {{"--history", "4", "--gather", "tiles"}, "--history"},
        {{"--history", "4", "--pipeline", "thesis"}, "--history"},
        {{"--guiding", "on", "--gather", "tiles"}, "--guiding"},
        {{"--guiding", "on", "--reseed", "off"}, "--guiding"},
        {{"--history", "-1"}, "--history"},
        {{"--gather-rays", "3", "--gather", "tiles"}, "--gather-rays"},
        {{"--gather-rays", "3", "--pipeline", "thesis"}, "--gather-rays"},
        {{"--filter-levels", "2", "--gather", "tiles"}, "--filter-levels"},
        {{"--filter-levels", "2", "--pipeline", "direct"}, "--filter-levels"},
        {{"--shadow-divisor", "4", "--pipeline", "thesis"}, "--shadow-divisor"},
        {{"--shadow-rays", "8", "--pipeline", "thesis"}, "--shadow-rays"},
        {{"--photons", "9", "--pipeline", "direct"}, "--photons"},
        {{"--radius", "1", "--pipeline", "direct"}, "--radius"},
        {{"--max-bounces", "1", "--pipeline", "direct"}, "--max-bounces"},
        {{"--gather", "tiles", "--pipeline", "direct"}, "--gather"},
        {{"--gather-divisor", "2", "--pipeline", "direct"}, "--gather-divisor"},
        {{"--reseed", "maybe"}, "maybe"},
        {{"--retrace", "none"}, "none"},
        {{"--tonemap", "aces"}, "aces"},
        {{"--exposure", "bright"}, "--exposure"},
        {{"--exposure", "nan"}, "--exposure"},
        {{"--time", "inf"}, "--time"},
        {{"--seed", "x"}, "--seed"},
        {{"--seed", "-1"}, "--seed"},
        {{"--light-cutoff", "-0.1"}, "--light-cutoff"},
        {{"--graph", folder / "g.svg"}, ".dot or .json"},
        {{"--report", folder / "r.txt"}, ".json"},
        {{"--trace", folder / "t.txt"}, ".json"},
        {{"--report", folder / "a.json", "--trace", folder / "a.json"}, "twice"},
        {{"--colour"}, "--colour"},
        {{"--pipeline", "thesis", "--max-bounces", "2"}, "one bounce"},
    };
    for (const auto& [more, what] : calls) {
        SCOPED_TRACE(testing::PrintToString(more));
        Arguments arguments{"render", "cornell", "-o", folder / "a.png"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        expectWrongCall(lampyris(arguments), what);
    }
    expectWrongCall(render("cornell", folder / "a.jpg"), ".png or .exr");
    expectWrongCall(render("cornell", folder / "a"), ".png or .exr");
    EXPECT_EQ(folder.files(), 0u);
}

TEST(WrongCall, HelpIsNone) {
    for (const char* command : {"render", "view", "flicker", "bench", "info"}) {
        const Ran ran = lampyris({command, "--help"});
        EXPECT_EQ(ran.code, 0);
        EXPECT_EQ(ran.err, "");
        EXPECT_NE(ran.out.find("--device"), std::string::npos) << ran.out;
    }
    const Ran ran = lampyris({"--help"});
    EXPECT_EQ(ran.code, 0);
    EXPECT_NE(ran.out.find("render"), std::string::npos);
}

// What a preset chooses, and what is asked to be off, is no wrong call.
TEST(WrongCall, PresetsSuitEveryPipeline) {
    const ScratchFolder folder;
    const std::vector<Arguments> calls{
        {"--pipeline", "thesis", "--quality", "fine", "--history", "0", "--filter-levels", "0"},
        {"--pipeline", "direct", "--quality", "fine", "--max-bounces", "0", "--shadow-rays", "2"},
        {"--gather", "tiles", "--quality", "fine", "--photons", "100", "--shadow-divisor", "2"}};
    for (const Arguments& more : calls)
        EXPECT_EQ(render("cornell", folder / "a.png", more).code, 0)
            << testing::PrintToString(more);
}

TEST(WrongCall, ThesisTakesItsOneBounceOrNone) {
    const ScratchFolder folder;
    EXPECT_EQ(
        render("cornell", folder / "a.png", {"--pipeline", "thesis", "--max-bounces", "1"}).code,
        0);
    EXPECT_EQ(
        render("cornell", folder / "a.png", {"--pipeline", "thesis", "--max-bounces", "0"}).code,
        0);
}

}  // namespace
}  // namespace lampyris::test
