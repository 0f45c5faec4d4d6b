// `lampyris bench NAME`: one of the project's tables.
#include "bench.h"

#include <map>
#include <memory>
#include <vector>

#include "command.h"
#include "core/file.h"

namespace lampyris::sandbox {
namespace {

struct Benchmark {
    core::Result<void> (*run)(const BenchCall&);
    const char* what;
    std::vector<const char*> unused;  ///< options that mean nothing to it, or that it sets itself
};

const std::vector<const char*> kOfErrors{"--scene", "--reference", "--spp", "--exposure",
                                         "--tonemap"};

std::vector<const char*> with(std::vector<const char*> more) {
    more.insert(more.end(), kOfErrors.begin(), kOfErrors.end());
    return more;
}

const std::map<std::string, Benchmark> kBenchmarks{
    {"nodes",
     {benchNodes, "frame rate and GPU milliseconds a node, full beside thesis",
      with({"--pipeline"})}},
    {"binning",
     {benchBinning, "photons to tiles, gather and up-sampling, full beside thesis",
      with({"--pipeline", "--photons", "--radius", "--gather", "--gather-divisor", "--gather-rays",
            "--filter-levels", "--history"})}},
    {"budget",
     {benchBudget, "a budget of milliseconds for indirect light, kept while the load steps",
      with({"--pipeline", "--shadow-divisor", "--shadow-rays", "--gather", "--camera", "--history",
            "--time", "--retrace"})}},
    {"rays",
     {benchRays, "closest hits in the shader beside Embree",
      with({"--pipeline", "--quality", "--photons", "--radius", "--max-bounces", "--gather",
            "--gather-divisor", "--gather-rays", "--filter-levels", "--history", "--shadow-divisor",
            "--shadow-rays", "--light-cutoff"})}},
    {"accel", {benchAccel, "BVH builds and memory of the built-in scenes", with({})}},
    {"refit",
     {benchRefit, "refitting deforming meshes, on device and CPU, beside rebuilding and Embree",
      with({"--pipeline", "--quality", "--photons", "--radius", "--max-bounces", "--gather",
            "--gather-divisor", "--gather-rays", "--filter-levels", "--history", "--shadow-divisor",
            "--shadow-rays", "--light-cutoff", "--size"})}},
    {"motion",
     {benchMotion,
      "a moving frame beside a frozen and a still one, kept paths beside all anew",
      {"--pipeline", "--retrace", "--reference", "--spp", "--exposure", "--tonemap"}}},
    {"soak",
     {benchSoak, "the courtyard with things that come and go at random: fails where memory grows",
      with({"--pipeline", "--retrace", "--warmup"})}},
    {"parameter-scaling",
     {benchParameterScaling,
      "the Thesis' table 6.1: cost and error over paths and radius, thesis and full",
      {"--pipeline", "--photons", "--radius", "--light-cutoff", "--history"}}},
    {"fixed-budget",
     {benchFixedBudget,
      "table 6.2: paths that cost as much at each radius, thesis and full",
      {"--pipeline", "--photons", "--radius", "--light-cutoff", "--history"}}},
    {"scene-complexity",
     {benchSceneComplexity,
      "tables B.1 to B.4: cost in four scenes, thesis and full",
      {"--pipeline", "--photons", "--radius", "--light-cutoff", "--history", "--reference", "--spp",
       "--exposure", "--tonemap"}}},
    {"system-comparison",
     {benchSystemComparison,
      "table 6.3: full, at its cost thesis and the CPU reference, direct light with constant "
      "ambient",
      {"--pipeline", "--light-cutoff", "--history"}}}};

std::string listBenchmarks() {
    std::string list;
    for (const auto& [name, benchmark] : kBenchmarks)
        list += fmt::format("{}{}", list.empty() ? "" : ", ", name);
    return list;
}

std::string describeBenchmarks() {
    std::string text = "Benchmarks:\n";
    for (const auto& [name, benchmark] : kBenchmarks)
        text += fmt::format("  {:<18}  {}\n", name, benchmark.what);
    return text +
           "\nThe Thesis' tables are drawn at 1920x1080 with 20 frames a row, the last 5 compared; "
           "with --quick\nat 480x270 with 3 to 8 frames, scene-complexity at 320x180 and 9 of its "
           "25 "
           "rows a scene.\n";
}

core::Result<void> checkBench(const CLI::App& app, const std::string& name, const BenchCall& call) {
    if (!kBenchmarks.contains(name))
        return core::error("bench {}: there is no such benchmark; there are {}", name,
                           listBenchmarks());
    for (const char* option : kBenchmarks.at(name).unused)
        if (app.get_option(option)->count() > 0)
            return core::error("bench {} takes no {}", name, option);
    return checkCall(call.options);
}

/// Before hours of measuring: whether the folder is there and takes files.
core::Result<void> prepareFolder(const std::filesystem::path& folder) {
    if (folder.empty()) return {};
    std::error_code code;
    std::filesystem::create_directories(folder, code);
    if (code)
        return core::error("--out {}: the folder cannot be made: {}", folder.string(),
                           code.message());
    const std::filesystem::path probe = folder / ".lampyris";
    if (!core::writeFile(probe, std::string_view{}).ok())
        return core::error("--out {}: the folder cannot be written", folder.string());
    std::filesystem::remove(probe, code);
    return {};
}

core::Result<void> runBench(const std::string& name, const BenchCall& call) {
    if (call.samplesPerPixel == 0u)
        return core::error("--spp 0: a pixel needs at least one sample");
    TRY_VOID(prepareFolder(call.out));
    return kBenchmarks.at(name).run(call);
}

}  // namespace

void addBench(CLI::App& program, Command& called) {
    auto* app = program.add_subcommand("bench", "Measures, and prints a table");
    const auto call = std::make_shared<BenchCall>();
    const auto name = std::make_shared<std::string>();
    app->add_option("name", *name, "one of those below")->type_name("NAME")->required();
    app->footer(describeBenchmarks());
    app->add_option("--out", call->out,
                    "a folder for tables as CSV and Markdown, plots, and finished rows of the "
                    "Thesis' tables: a run that was stopped goes on from them")
        ->type_name("DIR");
    app->add_flag("--quick", call->quick, "smaller and fewer: minutes");
    addFrameOptions(*app, call->options);
    call->options.display.exposureEv = -1.0f;         // at which cornell is shown well
    call->options.retrace = photon_gi::Retrace::All;  // what is kept costs nothing to measure
    addCameraOptions(*app, call->options);
    addDisplayOptions(*app, call->options.display);
    app->add_option("--scene", call->scene, "in place of the scene of a Thesis' table (cornell)")
        ->type_name("NAME");
    app->add_option("--reference", call->reference,
                    "what errors are measured against (rendered, and kept in the folder)")
        ->type_name("FILE.exr");
    app->add_option("--spp", call->samplesPerPixel,
                    "samples a pixel of the reference that is rendered (512; quick 256)")
        ->check(CLI::Range(0u, 1u << 19u));
    app->callback([app, name, call, &called] {
        called.check = [app, name, call] { return checkBench(*app, *name, *call); };
        called.run = [name, call] { return runBench(*name, *call); };
    });
}

}  // namespace lampyris::sandbox
