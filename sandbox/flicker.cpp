// `lampyris flicker`: how much pictures tremble, and how long light takes to be seen.
#include <array>
#include <memory>

#include "command.h"
#include "core/file.h"
#include "core/image_io.h"
#include "core/log.h"
#include "evaluation/mssim.h"
#include "flicker/output.h"

namespace lampyris::sandbox {
namespace {

using flicker::Call;
using photon_gi::Pipeline;

// [chosen] round the defaults: what is drawn in a frame, and what it is smeared over.
constexpr std::array kSweptPaths{1000u, 2500u, 10000u};
constexpr std::array kSweptRadii{0.5f, 1.0f, 2.0f};

constexpr const char* kAbout =
    "static: mean over pixels of the standard deviation over time of luma of display values, and\n"
    "its 99th percentile. dynamic: changes from frame to frame that the reference's sequence has\n"
    "not, on 8x8 pixels. lag: frames after the strongest light is switched or moved until a tenth\n"
    "of the change is left. MSSIM: of the time-averaged frame against the reference. frozen: the\n"
    "same with the same paths in every frame.\n"
    "Here --frames is 64 (dynamic 32), --warmup the history and 8, --size 640x360 (dynamic 320x180 "
    "at most),\n"
    "--light-cutoff 0; without --pipeline, all are measured.";

core::Result<void> checkEnding(const char* flag, const std::filesystem::path& file,
                               const char* ending) {
    if (file.empty() || file.extension() == ending) return {};
    return core::error("{} {}: the file must end in {}", flag, file.string(), ending);
}

core::Result<void> checkFlicker(const Call& call) {
    const Options& o = call.options;
    TRY_VOID(checkCall(o));
    if (!o.reseed)
        return core::error(
            "--reseed off: flicker is that of paths drawn anew; a frozen sequence "
            "is measured beside it");
    if (call.sweep && (o.photons || o.radius))
        return core::error("--sweep sets --photons and --radius itself");
    if (call.sweep && call.oneAlone && o.pipeline == Pipeline::Direct)
        return core::error("--sweep is of indirect light; --pipeline direct has none");
    if (call.sweep && !call.map.empty())
        return core::error("--map: --sweep has too many maps for one picture");
    TRY_VOID(checkEnding("--map", call.map, ".png"));
    TRY_VOID(checkEnding("--csv", call.csv, ".csv"));
    return checkEnding("--plot", call.plot, ".svg");
}

core::Result<void> prepareFiles(const Call& call) {
    TRY_VOID(checkOutputs(call.options));
    for (const auto& file : {call.map, call.csv, call.plot}) TRY_VOID(checkTarget(file));
    const auto [width, height] = call.stillSize();
    if (std::min(width, height) < evaluation::kSsimWindow)
        return core::error("--size {}x{}: MSSIM needs {}x{} pixels or more", width, height,
                           evaluation::kSsimWindow, evaluation::kSsimWindow);
    if (call.samplesPerPixel == 0u)
        return core::error("--spp 0: a pixel needs at least one sample");
    if (call.out.empty()) return {};
    std::error_code code;
    std::filesystem::create_directories(call.out, code);
    if (code) return core::error("--out {}: {}", call.out.string(), code.message());
    return checkTarget(call.out / "flicker.csv");
}

/// What a pipeline cannot do is left out, where it is not the only one.
Options optionsFor(Pipeline pipeline, const Call& call) {
    Options options = call.options;
    options.pipeline = pipeline;
    options.retrace = photon_gi::Retrace::All;
    if (pipeline == Pipeline::Thesis && options.maxBounces.value_or(1) > 1)
        options.maxBounces.reset();
    return options;
}

struct Asked {
    std::string name;
    Options options;
};

std::vector<Asked> askedOf(const Call& call) {
    std::vector<Pipeline> pipelines{Pipeline::Full, Pipeline::Thesis, Pipeline::Direct};
    if (call.oneAlone) pipelines = {call.options.pipeline};
    std::vector<Asked> asked;
    for (const Pipeline pipeline : pipelines) {
        Options options = optionsFor(pipeline, call);
        if (!call.sweep) asked.push_back({name(pipeline), options});
        if (!call.sweep || pipeline == Pipeline::Direct) continue;
        for (const uint32_t paths : kSweptPaths)
            for (const float radius : kSweptRadii) {
                options.photons = paths;
                options.radius = radius;
                asked.push_back(
                    {fmt::format("{}, {} paths, {:g} m", name(pipeline), paths, radius), options});
            }
    }
    return asked;
}

core::Result<void> writeFiles(const Call& call, const std::vector<flicker::Row>& rows) {
    if (!call.map.empty()) TRY_VOID(core::writePng(call.map, flicker::mapOf(rows)));
    if (!call.csv.empty()) TRY_VOID(core::writeFile(call.csv, flicker::csvOf(rows)));
    if (!call.plot.empty()) TRY_VOID(core::writeFile(call.plot, flicker::plotOf(rows)));
    if (call.options.report.empty()) return {};
    return core::writeFile(call.options.report, flicker::reportOf(call, rows));
}

core::Result<void> measureFlicker(const Call& call) {
    TRY_VOID(prepareFiles(call));
    TRY(flicker::Truths truths, flicker::Truths::open(call));
    TRY_VOID(truths.still());
    core::releaseLog();
    std::vector<flicker::Row> rows;
    for (const auto& [name, options] : askedOf(call)) {
        TRY(flicker::Row row, flicker::measureRow(name, options, call, truths));
        rows.push_back(std::move(row));
    }
    TRY_VOID(writeFiles(call, rows));
    return publish(flicker::tableOf(call, rows), call.out);
}

}  // namespace

void addFlicker(CLI::App& program, Command& called) {
    auto* app =
        program.add_subcommand("flicker", "How much pictures tremble, and lag behind light");
    const auto call = std::make_shared<Call>();
    Options& options = call->options;
    app->add_option("scene", options.scene, "a built-in name, or a .gltf or .glb file")->required();
    addFrameOptions(*app, options);
    options.lightCutoff = 0.0f;  // a measurement
    addViewOptions(*app, options);
    app->add_option("--timestep", options.timestep, "seconds a frame, of dynamic flicker (1/60)")
        ->check(finite(0.0, 1e6));
    app->get_option("--frames")->check(CLI::Range(2u, 1000000u));
    app->add_flag("--sweep", call->sweep, "over --photons and --radius");
    app->add_option("--map", call->map, "write where they tremble, a pipeline each")
        ->type_name("OUT.png");
    app->add_option("--csv", call->csv, "write every frame's figures")->type_name("FILE.csv");
    app->add_option("--plot", call->plot, "draw them")->type_name("FILE.svg");
    app->add_option("--reference", call->reference, "of the still picture (rendered)")
        ->type_name("FILE.exr");
    app->add_option("--spp", call->samplesPerPixel,
                    "samples a pixel of the references (64; of dynamic flicker 16)")
        ->check(CLI::Range(0u, 1u << 19u));
    app->add_option("--out", call->out, "a folder for the table, and references for a later call")
        ->type_name("DIR");
    app->footer(kAbout);
    app->callback([app, call, &called] {
        call->oneAlone = app->get_option("--pipeline")->count() > 0;
        called.check = [call] { return checkFlicker(*call); };
        called.run = [call] { return measureFlicker(*call); };
    });
}

}  // namespace lampyris::sandbox
