// `lampyris bench NAME`: one of the project's tables.
#include "bench.h"

#include <map>
#include <memory>
#include <vector>

#include "command.h"
#include "progress.h"

namespace lampyris::sandbox {
namespace {

struct Benchmark {
    core::Result<void> (*run)(const BenchCall&);
    const char* what;
    std::vector<const char*> fixed{};  ///< options that it sets itself
};

const std::map<std::string, Benchmark> kBenchmarks{
    {"nodes",
     {benchNodes, "frame rate and GPU milliseconds a node, full beside thesis", {"--pipeline"}}},
    {"binning",
     {benchBinning,
      "photons to tiles, gather and up-sampling, full beside thesis",
      {"--pipeline", "--photons", "--radius"}}},
    {"rays", {benchRays, "closest hits in the shader beside Embree"}},
    {"accel", {benchAccel, "BVH builds and memory of the built-in scenes"}}};

std::string listBenchmarks() {
    std::string list;
    for (const auto& [name, benchmark] : kBenchmarks)
        list += fmt::format("{}{}: {}", list.empty() ? "" : "; ", name, benchmark.what);
    return list;
}

core::Result<void> checkBench(const CLI::App& app, const std::string& name, const BenchCall& call) {
    if (!kBenchmarks.contains(name))
        return core::error("bench {}: there is no such benchmark; there are {}", name,
                           listBenchmarks());
    for (const char* option : kBenchmarks.at(name).fixed)
        if (app.get_option(option)->count() > 0)
            return core::error("bench {} sets {} itself", name, option);
    return checkCall(call.options);
}

core::Result<void> runBench(const std::string& name, const BenchCall& call) {
    std::error_code code;
    if (!call.out.empty()) std::filesystem::create_directories(call.out, code);
    if (code) return core::error("{}: {}", call.out.string(), code.message());
    return kBenchmarks.at(name).run(call);
}

}  // namespace

core::Result<void> race(std::vector<Contestant>& contestants, uint32_t warmup, uint32_t frames) {
    std::vector<std::unique_ptr<FrameLoop>> loops;
    for (Contestant& contestant : contestants) {
        TRY(auto loop, FrameLoop::open(contestant.options));
        contestant.size = loop->request.size;
        contestant.device = loop->device().info().name;
        loops.push_back(std::move(loop));
    }
    Progress progress{"frame", warmup + frames};
    for (uint32_t i = 0; i < warmup + frames; ++i) {
        progress.show(i);
        for (size_t c = 0; c < contestants.size(); ++c) {
            TRY(const LoopFrame frame, loops[c]->draw(i));
            contestants[c].report = frame.outcome.report;
            if (i >= warmup) contestants[c].series.add(frame.outcome.statistics);
        }
    }
    return {};
}

void addBench(CLI::App& program, Command& called) {
    auto* app = program.add_subcommand("bench", "Measures, and prints a table");
    const auto call = std::make_shared<BenchCall>();
    const auto name = std::make_shared<std::string>();
    app->add_option("name", *name, listBenchmarks())->required();
    app->add_option("--out", call->out, "a folder for the table as CSV and Markdown")
        ->type_name("DIR");
    app->add_flag("--quick", call->quick, "smaller and fewer");
    addFrameOptions(*app, call->options);
    app->callback([app, name, call, &called] {
        called.check = [app, name, call] { return checkBench(*app, *name, *call); };
        called.run = [name, call] { return runBench(*name, *call); };
    });
}

}  // namespace lampyris::sandbox
