// `lampyris bench`: tables, plots, and runs that are stopped and taken up again.
#include <algorithm>
#include <chrono>
#include <fstream>
#include <limits>
#include <thread>

#include "cli/program/program.h"
#include "core/image_io.h"

namespace lampyris::test {
namespace {

/// The smallest that still measures: pictures must hold SSIM's window.
Arguments bench(const std::string& name, const std::string& out, const Arguments& more = {}) {
    Arguments arguments{"bench", name, "--quick", "--out", out};
    const auto without = [&](const char* option) {
        return std::find(more.begin(), more.end(), option) == more.end();
    };
    if (without("--size")) arguments.insert(arguments.end(), {"--size", "64x36"});
    if (without("--frames")) arguments.insert(arguments.end(), {"--frames", "1"});
    if (name != "soak") arguments.insert(arguments.end(), {"--warmup", "0"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

size_t linesOf(const std::filesystem::path& path) {
    const std::string text = textOf(path);
    return static_cast<size_t>(std::count(text.begin(), text.end(), '\n'));
}

size_t countOf(const std::string& text, const std::string& what) {
    size_t count = 0;
    for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
        ++count;
    return count;
}

void expectFiles(const std::filesystem::path& folder, const std::vector<std::string>& names) {
    for (const std::string& name : names)
        EXPECT_FALSE(textOf(folder / name).empty()) << name << " is not there";
}

TEST(Bench, PrintsTablesAndWritesThem) {
    const ScratchFolder folder;
    const std::vector<std::pair<std::string, std::vector<std::string>>> benchmarks{
        {"nodes", {"nodes"}}, {"binning", {"binning", "photon_gi"}}};
    for (const auto& [name, tables] : benchmarks) {
        const std::filesystem::path out = folder / name;
        const Ran ran = lampyris(bench(name, out, {"--size", "160x90"}));
        ASSERT_EQ(ran.code, 0) << ran.err;
        EXPECT_NE(ran.out.find("thesis"), std::string::npos);
        for (const std::string& table : tables) {
            const std::string csv = textOf(out / (table + ".csv"));
            EXPECT_NE(csv.find("thesis"), std::string::npos) << table;
            EXPECT_NE(textOf(out / (table + ".md")).find("| "), std::string::npos) << table;
        }
    }
}

TEST(Bench, Motion) {
    const ScratchFolder folder;
    const Ran ran = lampyris(bench("motion", folder / "out", {"--history", "1"}));
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(linesOf(folder / "out/motion.csv"), 6u) << "five ways, a header\n" << ran.out;
    const std::string table = textOf(folder / "out/motion.csv");
    for (const char* way : {"moving, all retraced", "frozen, all retraced", "moving, auto",
                            "still, auto, history filling", "still, auto, history full"})
        EXPECT_NE(table.find(way), std::string::npos) << way << "\n" << table;
    // The figures of a way stand behind its name, which holds commas.
    const size_t full = table.find("history full");
    ASSERT_NE(full, std::string::npos);
    EXPECT_NE(table.find("yes,0.000,0.00,0.00,", full), std::string::npos)
        << "what is settled retraces, refits and rebuilds nothing\n"
        << table;
    // Nothing moves in cornell; any scene will do.
    EXPECT_EQ(lampyris(bench("motion", folder / "cornell",
                             {"--history", "0", "--scene", "cornell", "--max-bounces", "1"}))
                  .code,
              0);
}

TEST(Bench, Budget) {
    const ScratchFolder folder;
    const Ran ran = lampyris(bench("budget", folder / "out", {"--frames", "2"}));
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(linesOf(folder / "out/budget.csv"), 4u) << "three steps, a header\n" << ran.out;
    EXPECT_EQ(linesOf(folder / "out/budget_frames.csv"), 7u);
    expectFiles(folder / "out", {"budget.md"});
}

TEST(Bench, Soak) {
    const ScratchFolder folder;
    const Ran ran = lampyris(bench("soak", folder / "out", {"--frames", "6", "--validation"}));
    ASSERT_EQ(ran.code, 0) << ran.err;
    const std::string counts = textOf(folder / "out/soak_counts.csv");
    EXPECT_NE(counts.find("validation messages,0"), std::string::npos) << counts;
    EXPECT_NE(counts.find("dropped in frames that were reported,0"), std::string::npos) << counts;
    EXPECT_NE(textOf(folder / "out/soak_memory.csv").find("frame 3,frame 5"), std::string::npos);
    expectFiles(folder / "out", {"soak_memory.md", "soak_counts.md"});
}

TEST(Bench, ListsWhatThereIs) {
    const Ran ran = lampyris({"bench", "--help"});
    EXPECT_EQ(ran.code, 0);
    for (const char* name :
         {"nodes", "binning", "budget", "rays", "accel", "refit", "motion", "soak"})
        EXPECT_NE(ran.out.find("  " + std::string(name) + " "), std::string::npos) << name;
}

TEST(Bench, ParameterScaling) {
    const ScratchFolder folder;
    const Ran ran = lampyris(bench("parameter-scaling", folder / "out", {"--spp", "4"}));
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    EXPECT_EQ(linesOf(folder / "out/parameter-scaling-thesis.csv"), 26u) << "25 rows, a header";
    EXPECT_EQ(linesOf(folder / "out/parameter-scaling-full.csv"), 26u);
    EXPECT_NE(ran.out.find("902.23"), std::string::npos) << "the Thesis' own column";
    expectFiles(folder / "out", {"parameter-scaling-thesis.md", "parameter-scaling-full.md",
                                 "parameter-scaling-ms.svg", "parameter-scaling-mse.svg",
                                 "parameter-scaling-mssim.svg"});
    // Again: nothing is measured, and the table is the same to the last digit.
    const size_t rows = linesOf(folder / "out/parameter-scaling.rows.jsonl");
    EXPECT_EQ(rows, 25u);
    EXPECT_EQ(lampyris(bench("parameter-scaling", folder / "out", {"--spp", "4"})).out, ran.out);
    EXPECT_EQ(linesOf(folder / "out/parameter-scaling.rows.jsonl"), rows);
}

TEST(Bench, FixedBudget) {
    const ScratchFolder folder;
    const Ran ran = lampyris(bench("fixed-budget", folder / "out", {"--spp", "4"}));
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(linesOf(folder / "out/fixed-budget-thesis.csv"), 9u);
    EXPECT_EQ(linesOf(folder / "out/fixed-budget-full.csv"), 9u);
    EXPECT_EQ(linesOf(folder / "out/fixed-budget-estimators.csv"), 10u) << "three times three";
    EXPECT_NE(ran.out.find("446.30"), std::string::npos) << "the Thesis' own column";
    expectFiles(folder / "out", {"fixed-budget-estimators.svg", "fixed-budget-costs.svg"});
}

TEST(Bench, SceneComplexity) {
    const ScratchFolder folder;
    // The other three scenes take seconds to build.
    const Ran ran = lampyris(bench("scene-complexity", folder / "out", {"--scene", "cornell"}));
    ASSERT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(linesOf(folder / "out/scene-complexity-cornell.csv"), 10u);
    EXPECT_NE(ran.out.find("136.8"), std::string::npos) << "the Thesis' own column";
    expectFiles(folder / "out", {"scene-complexity-cornell.md", "scene-complexity-costs.svg"});
}

TEST(Bench, SystemComparison) {
    const ScratchFolder folder;
    const Ran ran = lampyris(bench("system-comparison", folder / "out", {"--spp", "4"}));
    ASSERT_EQ(ran.code, 0) << ran.err;
    for (const char* system : {"thesis, 1000 paths", "full ", "direct + ambient", "reference, ",
                               "paper: Prototype", "3589.49"})
        EXPECT_NE(ran.out.find(system), std::string::npos) << system << "\n" << ran.out;
    const std::string csv = textOf(folder / "out/system-comparison.csv");
    EXPECT_EQ(countOf(csv, "thesis, "), 2u) << "its own paths, and those of equal time\n" << csv;
    expectFiles(folder / "out",
                {"system-comparison.csv", "system-comparison.md", "system-comparison-errors.svg"});
    // Again: the search, the race and the rest are taken from the kept rows.
    const size_t rows = linesOf(folder / "out/system-comparison.rows.jsonl");
    EXPECT_EQ(rows, 4u) << "search, race, ambient, reference";
    EXPECT_EQ(lampyris(bench("system-comparison", folder / "out", {"--spp", "4"})).out, ran.out);
    EXPECT_EQ(linesOf(folder / "out/system-comparison.rows.jsonl"), rows);
}

TEST(Bench, TakesAReferenceFromAFile) {
    const ScratchFolder folder;
    const std::string file = folder / "truth.exr";
    ASSERT_EQ(lampyris({"reference", "cornell", "-o", file, "--size", "64x36", "--spp", "2"}).code,
              0);
    const Arguments given{"--reference", file};
    const Ran ran = lampyris(bench("system-comparison", folder / "out", given));
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_NE(ran.out.find("truth.exr"), std::string::npos) << ran.out;
    expectFailure(lampyris(bench("system-comparison", folder / "out",
                                 {"--reference", file, "--size", "80x45"})),
                  "truth.exr: is 64x36, the frames are 80x45");
    std::filesystem::resize_file(file, 100);
    expectFailure(lampyris(bench("system-comparison", folder / "out", given)), "truth.exr: EXR: ");
    core::Image bad(64, 36, 3);
    bad.values[5] = std::numeric_limits<float>::quiet_NaN();
    ASSERT_TRUE(core::writeExr(file, bad).ok());
    expectFailure(lampyris(bench("system-comparison", folder / "out", given)),
                  "truth.exr: NaN in blue of the pixel at (1, 0)");
    std::filesystem::remove(file);
    expectFailure(lampyris(bench("system-comparison", folder / "out", given)),
                  "truth.exr: No such file");
    std::filesystem::create_directory(file);
    expectFailure(lampyris(bench("system-comparison", folder / "out", given)),
                  "truth.exr: is a folder");
}

TEST(Bench, KeepsItsRowsWhereATableCannotBeWritten) {
    const ScratchFolder folder;
    const std::filesystem::path rows = folder / "out/scene-complexity.rows.jsonl";
    const std::filesystem::path table = folder / "out/scene-complexity-cornell.csv";
    std::filesystem::create_directories(table);
    const Arguments arguments = bench("scene-complexity", folder / "out", {"--scene", "cornell"});
    const Ran refused = lampyris(arguments);
    EXPECT_EQ(refused.code, 1);
    EXPECT_EQ(refused.errorLines(), 1u) << refused.err;
    EXPECT_NE(refused.err.find("scene-complexity-cornell.csv"), std::string::npos) << refused.err;
    const std::string before = textOf(rows);
    EXPECT_EQ(linesOf(rows), 9u);
    std::filesystem::remove(table);
    EXPECT_EQ(lampyris(arguments).code, 0);
    EXPECT_EQ(textOf(rows), before) << "nothing is measured twice";
    EXPECT_EQ(linesOf(table), 10u);
}

TEST(Bench, AStoppedRunIsTakenUpAgain) {
    const ScratchFolder folder;
    const std::filesystem::path rows = folder / "out/scene-complexity.rows.jsonl";
    const Arguments arguments = bench("scene-complexity", folder / "out",
                                      {"--scene", "cornell", "--size", "320x180", "--frames", "4"});
    {
        Arguments command{programPath()};
        command.insert(command.end(), arguments.begin(), arguments.end());
        Process stopped(command);
        while (stopped.running() && linesOf(rows) < 2)
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        ASSERT_TRUE(stopped.running()) << "too quick to be stopped";
    }
    const std::string before = textOf(rows);
    ASSERT_FALSE(std::filesystem::exists(folder / "out/scene-complexity-cornell.csv"));
    const Ran ran = lampyris(arguments);
    EXPECT_EQ(ran.code, 0) << ran.err;
    const std::string after = textOf(rows);
    EXPECT_EQ(after.substr(0, before.size()), before) << "finished rows stand";
    EXPECT_EQ(linesOf(rows), 9u) << "and none is measured twice";
    EXPECT_EQ(linesOf(folder / "out/scene-complexity-cornell.csv"), 10u);
}

TEST(Bench, RowsOfOtherSettingsAreNotTaken) {
    const ScratchFolder folder;
    const std::filesystem::path rows = folder / "out/scene-complexity.rows.jsonl";
    const Arguments scene{"--scene", "cornell"};
    size_t expected = 0;
    for (const Arguments& more :
         {Arguments{}, Arguments{"--frames", "2"}, Arguments{"--size", "80x45"},
          Arguments{"--seed", "5"}, Arguments{"--gather-divisor", "4"},
          Arguments{"--max-bounces", "2"}}) {
        Arguments all = scene;
        all.insert(all.end(), more.begin(), more.end());
        ASSERT_EQ(lampyris(bench("scene-complexity", folder / "out", all)).code, 0);
        expected += 9;
        EXPECT_EQ(linesOf(rows), expected) << testing::PrintToString(more);
    }
}

TEST(Bench, BadInputIsOneLine) {
    const ScratchFolder folder;
    const std::string file = folder / "file";
    std::ofstream(file) << "no folder";
    expectFailure(lampyris(bench("parameter-scaling", file)), "file: the folder cannot be made");
    expectFailure(lampyris(bench("parameter-scaling", "/proc/lampyris")), "/proc/lampyris");
    expectFailure(lampyris(bench("fixed-budget", "/proc")), "/proc: the folder cannot be written");
    expectFailure(lampyris(bench("nodes", "/proc")), "/proc: the folder cannot be written");
    expectFailure(lampyris(bench("system-comparison", folder / "out", {"--spp", "0"})), "--spp 0");
    expectFailure(lampyris(bench("system-comparison", folder / "out", {"--camera", "nobody"})),
                  "nobody");
    expectFailure(lampyris(bench("scene-complexity", folder / "out", {"--scene", "nowhere"})),
                  "nowhere");
    // What is in the way of rows is named before anything is measured.
    std::filesystem::create_directories(folder / "taken/system-comparison.rows.jsonl");
    expectFailure(lampyris(bench("system-comparison", folder / "taken")), "rows.jsonl");
}

}  // namespace
}  // namespace lampyris::test
