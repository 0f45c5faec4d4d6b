// `lampyris flicker`: how still a still picture is, how truly a moving one moves, and how long
// light lags behind. None is printed without the others, nor without the MSSIM of the averaged
// frame.
#include <fmt/format.h>

#include <array>
#include <memory>

#include "command.h"
#include "core/file.h"
#include "core/image_io.h"
#include "evaluation/heat_map.h"
#include "flicker/measure.h"
#include "plot/chart.h"
#include "table.h"

namespace lampyris::sandbox {
namespace {

using namespace flicker;
using photon_gi::Pipeline;

constexpr graph::Extent kSize{640, 360};
constexpr float kBrightestDeviation = 8.0f;  // [chosen] of the heat map, in steps of luma
// [chosen] Factors of the sweep on each pipeline's own photons and radius.
constexpr std::array<float, 3> kSweep{0.25f, 1.0f, 4.0f};
constexpr std::array<float, 3> kRadiusSweep{0.5f, 1.0f, 2.0f};

std::string lagText(const FlickerFigures& f, LightChange change) {
    const auto lag = f.lags.find(nameOf(change));
    if (lag == f.lags.end()) return "-";
    return lag->second.arrives ? fmt::format("{}", lag->second.frames) : "> 96";
}

/// "void" where the references' own difference is no small part of the figure.
std::string dynamicText(const FlickerFigures& f, double floor) {
    if (!f.moves) return "nothing moves";
    const bool known = floor < 0.25 * f.dynamic.mean;
    return fmt::format("{:.3f}{}", f.dynamic.mean, known ? "" : " (void)");
}

Table tableOf(const std::vector<FlickerFigures>& all, const Truths& truths,
              const FlickerCall& call) {
    const graph::Extent size = sizeOf(call.options);
    Table table{
        "flicker",
        fmt::format("flicker of luma, 0 to 255, {} at {}x{}, exposure {:g}; fresh paths in "
                    "every frame; lag in frames after a light's change",
                    call.options.scene, size.width, size.height, call.options.display.exposureEv),
        {"pipeline", "photons", "radius", "static", "static p99", "frozen", "dynamic", "floor",
         "lag off", "lag on", "lag moved", "MSSIM"},
        {}};
    for (const FlickerFigures& f : all)
        table.rows.push_back(
            {f.name, fmt::format("{}", f.photons), fmt::format("{:g}", f.radiusMetres),
             fmt::format("{:.3f}", f.still.mean), fmt::format("{:.3f}", f.still.percentile99),
             fmt::format("{:.3f}", f.frozen), dynamicText(f, truths.floor),
             f.moves ? fmt::format("{:.3f}", truths.floor) : "-", lagText(f, LightChange::Off),
             lagText(f, LightChange::On), lagText(f, LightChange::Moved),
             fmt::format("{:.4f}", f.mssim)});
    return table;
}

Table sweepTable(const std::vector<FlickerFigures>& all) {
    Table table{"flicker_sweep",
                "the same over photons and radius",
                {"pipeline", "photons", "radius", "static", "static p99", "lag off", "MSSIM"},
                {}};
    for (const FlickerFigures& f : all)
        table.rows.push_back(
            {f.name, fmt::format("{}", f.photons), fmt::format("{:g}", f.radiusMetres),
             fmt::format("{:.3f}", f.still.mean), fmt::format("{:.3f}", f.still.percentile99),
             lagText(f, LightChange::Off), fmt::format("{:.4f}", f.mssim)});
    return table;
}

std::string csvOf(const std::vector<FlickerFigures>& all) {
    std::string csv = "pipeline,photons,radius,figure,frame,value\n";
    for (const FlickerFigures& f : all) {
        const auto add = [&](const std::string& figure, const std::vector<double>& values,
                             size_t first) {
            for (size_t t = 0; t < values.size(); ++t)
                csv += fmt::format("{},{},{:g},{},{},{:.6g}\n", f.name, f.photons, f.radiusMetres,
                                   figure, t + first, values[t]);
        };
        add("still_change", f.stillFrames, 1);
        add("dynamic", f.dynamic.frames, 1);
        for (const auto& [change, lag] : f.lags) add("lag_" + change, lag.differences, 0);
    }
    return csv;
}

std::vector<plot::Point> pointsOf(const std::vector<double>& values) {
    std::vector<plot::Point> points;
    for (size_t t = 0; t < values.size(); ++t)
        points.push_back({static_cast<double>(t), values[t]});
    return points;
}

std::string plotOf(const std::vector<FlickerFigures>& all) {
    plot::Chart still{"nothing moves", "frame", "mean change of luma", plot::Scale::Linear, {}};
    plot::Chart moving{"moving", "frame", "dynamic flicker", plot::Scale::Linear, {}};
    plot::Chart lag{"a light switched off", "frames after", "difference to the settled picture", plot::Scale::Logarithmic, {}};
    for (const FlickerFigures& f : all) {
        still.series.push_back({f.name, pointsOf(f.stillFrames), true, false});
        if (f.moves) moving.series.push_back({f.name, pointsOf(f.dynamic.frames), true, false});
        const auto off = f.lags.find(nameOf(LightChange::Off));
        if (off != f.lags.end())
            lag.series.push_back({f.name, pointsOf(off->second.differences), true, false});
    }
    std::vector<plot::Chart> charts{still};
    if (!moving.series.empty()) charts.push_back(moving);
    if (!lag.series.empty()) charts.push_back(lag);
    return plot::sideBySide(charts);
}

core::Result<std::vector<FlickerFigures>> sweep(const FlickerCall& call,
                                                const std::vector<Options>& asked, Truths& truths) {
    std::vector<FlickerFigures> all;
    for (const Options& options : asked) {
        const photon_gi::Settings own = settingsOf(options);
        for (const float photons : kSweep)
            for (const float radius : kRadiusSweep) {
                Options other = options;
                other.photons =
                    static_cast<uint32_t>(photons * static_cast<float>(own.photonPaths));
                other.radius = radius * own.radiusMetres;
                TRY(auto figures, measure(call, other, truths, false));
                all.push_back(std::move(figures));
            }
    }
    return all;
}

std::vector<Options> askedOf(const FlickerCall& call) {
    if (!call.allPipelines) return {call.options};
    std::vector<Options> asked;
    for (const Pipeline pipeline : {Pipeline::Full, Pipeline::Thesis}) {
        asked.push_back(call.options);
        asked.back().pipeline = pipeline;
        if (pipeline == Pipeline::Thesis) asked.back().history.reset();
    }
    return asked;
}

core::Result<void> run(const FlickerCall& call) {
    for (const auto& path : {call.map, call.csv, call.plot}) TRY_VOID(checkTarget(path));
    const std::vector<Options> asked = askedOf(call);
    Truths truths;
    TRY(truths.still, stillTruth(call));
    std::vector<FlickerFigures> all;
    for (const Options& options : asked) {
        TRY(auto figures, measure(call, options, truths, true));
        all.push_back(std::move(figures));
    }
    if (!call.map.empty())
        TRY_VOID(core::writePng(call.map,
                                evaluation::heatMap(all.front().still.map, kBrightestDeviation)));
    if (!call.csv.empty()) TRY_VOID(core::writeFile(call.csv, csvOf(all)));
    if (!call.plot.empty()) TRY_VOID(core::writeFile(call.plot, plotOf(all)));
    TRY_VOID(publish(tableOf(all, truths, call), {}));
    if (!call.sweep) return {};
    TRY(const auto swept, sweep(call, asked, truths));
    return publish(sweepTable(swept), {});
}

core::Result<void> check(const FlickerCall& call) {
    if (!call.options.reseed)
        return core::error("flicker is measured with fresh paths; a frozen sequence stands beside");
    if (call.options.frames.value_or(2) < 2)
        return core::error("--frames {}: flicker needs two pictures at least",
                           *call.options.frames);
    if (call.samplesPerPixel == 0 || call.movingSamplesPerPixel == 0)
        return core::error("a reference needs a sample a pixel at least");
    const std::array<std::pair<const std::filesystem::path*, const char*>, 3> files{
        std::pair{&call.map, ".png"}, std::pair{&call.csv, ".csv"}, std::pair{&call.plot, ".svg"}};
    for (const auto& [path, ending] : files)
        if (!path->empty() && path->extension() != ending)
            return core::error("{}: the file must end in {}", path->string(), ending);
    return checkCall(call.options);
}

}  // namespace

void addFlicker(CLI::App& program, Command& called) {
    auto* app = program.add_subcommand(
        "flicker", "How still a picture is, how truly it moves, and how long its light lags");
    const auto call = std::make_shared<FlickerCall>();
    call->options.size = kSize;
    app->add_option("scene", call->options.scene, "a built-in name, or a .gltf or .glb file")
        ->required();
    addFrameOptions(*app, call->options);
    addCameraOptions(*app, call->options);
    addDisplayOptions(*app, call->options.display);
    app->add_option("--timestep", call->options.timestep, "seconds a frame of what moves (1/60)")
        ->check(finite(0.0, 1e6));
    app->add_option("--spp", call->samplesPerPixel, "of the still reference (64)");
    app->add_option("--moving-spp", call->movingSamplesPerPixel,
                    "of each frame of the moving reference (32)");
    app->add_option("--map", call->map, "static flicker of the first pipeline as a heat map")
        ->type_name("OUT.png");
    app->add_option("--csv", call->csv, "every frame's part")->type_name("FILE.csv");
    app->add_option("--plot", call->plot, "the same over time")->type_name("FILE.svg");
    app->add_flag("--sweep", call->sweep, "again over photons and radius");
    app->callback([app, call, &called] {
        called.check = [app, call] {
            call->allPipelines = app->get_option("--pipeline")->count() == 0;
            return check(*call);
        };
        called.run = [call] { return run(*call); };
    });
}

}  // namespace lampyris::sandbox
