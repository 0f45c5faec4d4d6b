// `lampyris bench nodes`: what a frame of `cornell` costs, node by node, in both pipelines.
#include <fmt/format.h>

#include <algorithm>

#include "bench.h"
#include "table.h"

namespace lampyris::sandbox {
namespace {

using photon_gi::Pipeline;

Contestant contestant(const BenchCall& call, Pipeline pipeline) {
    Contestant c{name(pipeline), call.options};
    c.options.scene = "cornell";
    c.options.pipeline = pipeline;
    c.options.size = call.options.size.value_or(graph::Extent{640, 360});
    c.options.photons = call.options.photons.value_or(1000);
    if (pipeline == Pipeline::Thesis) c.options.maxBounces.reset();
    return c;
}

/// Names in the order of the frame, those of the first contestant first.
std::vector<std::string> allNodes(const std::vector<Contestant>& contestants) {
    std::vector<std::string> names;
    for (const Contestant& c : contestants)
        for (const NodeSummary& node : c.series.summariseNodes())
            if (std::find(names.begin(), names.end(), node.name) == names.end())
                names.push_back(node.name);
    return names;
}

void addNode(Table& table, const std::vector<Contestant>& contestants, const std::string& node) {
    std::vector<std::string> row{node};
    for (const Contestant& c : contestants) {
        const auto nodes = c.series.summariseNodes();
        const auto found = std::find_if(nodes.begin(), nodes.end(),
                                        [&](const NodeSummary& n) { return n.name == node; });
        const double frame = summarise(c.series.frameMilliseconds()).median;
        const bool there = found != nodes.end();
        row.push_back(there ? fmt::format("{:.2f}", found->gpuMilliseconds.median) : "–");
        row.push_back(there ? fmt::format("{:.0f}", 100.0 * found->gpuMilliseconds.median / frame)
                            : "–");
    }
    table.rows.push_back(std::move(row));
}

void addTotals(Table& table, const std::vector<Contestant>& contestants) {
    std::vector<std::string> frame{"frame"};
    std::vector<std::string> rate{"frames a second"};
    for (const Contestant& c : contestants) {
        const double median = summarise(c.series.frameMilliseconds()).median;
        frame.insert(frame.end(), {fmt::format("{:.2f}", median), "100"});
        rate.insert(rate.end(), {fmt::format("{:.1f}", 1000.0 / median), ""});
    }
    table.rows.push_back(std::move(frame));
    table.rows.push_back(std::move(rate));
}

}  // namespace

core::Result<void> benchNodes(const BenchCall& call) {
    std::vector<Contestant> contestants{contestant(call, Pipeline::Full),
                                        contestant(call, Pipeline::Thesis)};
    const uint32_t frames = call.options.frames.value_or(call.quick ? 10 : 60);
    TRY_VOID(race(contestants, {call.options.warmup.value_or(3), frames}));
    const Contestant& full = contestants.front();
    const photon_gi::Settings settings = settingsOf(full.options);
    Table table{"nodes", {}, {"node", "full ms", "full %", "thesis ms", "thesis %"}, {}};
    table.title = fmt::format(
        "cornell, {}x{}, {} paths, radius {} m, {} bounces in full and 1 in thesis; medians of {} "
        "frames on {}",
        full.size.width, full.size.height, settings.photonPaths, settings.radiusMetres,
        settings.maxBounces, frames, full.device);
    for (const std::string& node : allNodes(contestants)) addNode(table, contestants, node);
    addTotals(table, contestants);
    return publish(table, call.out);
}

}  // namespace lampyris::sandbox
