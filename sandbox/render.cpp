// `lampyris render`: headless frames; writes the last.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "command.h"
#include "core/image_io.h"
#include "progress.h"
#include "results.h"
#include "table.h"

namespace lampyris::sandbox {
namespace {

struct RenderOptions : Options {
    bool table = false;
};

Table nodeTable(const FrameSeries& series, const std::string& title) {
    Table table{"nodes", title, {"node", "median ms", "p95 ms", "share"}, {}};
    const Statistics frame = summarise(series.frameMilliseconds());
    const auto addRow = [&](const std::string& name, const Statistics& s) {
        table.rows.push_back({name, fmt::format("{:.2f}", s.median), fmt::format("{:.2f}", s.p95),
                              fmt::format("{:.0f} %", 100.0 * s.mean / frame.mean)});
    };
    for (const NodeSummary& node : series.summariseNodes()) addRow(node.name, node.gpuMilliseconds);
    addRow("frame", frame);
    return table;
}

core::Result<void> render(const RenderOptions& o) {
    TRY_VOID(checkOutputs(o));
    TRY(const std::unique_ptr<FrameLoop> loop, FrameLoop::open(o));
    const uint32_t warmup = o.warmup.value_or(0);
    const uint32_t total = warmup + o.frames.value_or(1);
    Measured measured;
    execute::ChromeTrace trace;
    {
        Progress progress{"frame", total};
        for (uint32_t i = 0; i < total; ++i) {
            progress.show(i);
            TRY(LoopFrame frame, loop->draw(i, i + 1 == total));
            if (i < warmup) {
                measured.series.list(frame.outcome.statistics);
                continue;
            }
            trace.add(frame.outcome.statistics);
            measured.add(std::move(frame));
        }
    }
    TRY_VOID(core::writeImage(o.output, measured.last.outcome.image, o.display));
    TRY_VOID(writeResults(o, *loop, measured, trace));
    if (!o.table) return {};
    const auto title = fmt::format("GPU milliseconds a node, {} frames, {}",
                                   measured.series.frames(), loop->device().info().name);
    return publish(nodeTable(measured.series, title), {});
}

}  // namespace

void addRender(CLI::App& program, Command& called) {
    auto* app = program.add_subcommand("render", "Headless frames; writes the last");
    const auto options = std::make_shared<RenderOptions>();
    app->add_option("scene", options->scene, "a built-in name, or a .gltf or .glb file")
        ->required();
    app->add_option("-o,--output", options->output, "the picture: EXR is linear radiance")
        ->type_name("OUT.(png|exr)")
        ->required();
    addFrameOptions(*app, *options);
    addPictureOptions(*app, *options);
    app->add_option(
           "--output-node", options->outputNode,
           "another image: direct, indirect, irradiance_direct, irradiance_indirect, albedo, "
           "normal, position, depth, edges, … (final)")
        ->type_name("NAME");
    app->add_flag("--table", options->table, "print GPU milliseconds a node");
    app->callback([options, &called] {
        called.check = [options] { return checkCall(*options); };
        called.run = [options] { return render(*options); };
    });
}

}  // namespace lampyris::sandbox
