// `lampyris reference`: the CPU path tracer that frames are measured against.
#include "reference/reference.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "camera_choice.h"
#include "command.h"
#include "core/file.h"
#include "core/image_io.h"
#include "core/log.h"
#include "open_world.h"
#include "options.h"
#include "progress.h"
#include "scene/extract.h"

namespace lampyris::sandbox {
namespace {

struct ReferenceOptions : Options {
    uint32_t samplesPerPixel = 64;
    float maxError = 0.0f;
    std::string transport = "diffuse";
    bool smoothIndirect = false;
    uint32_t threads = 0;
    std::filesystem::path all;
};

reference::Settings settingsOf(const ReferenceOptions& o) {
    reference::Settings s;
    s.width = sizeOf(o).width;
    s.height = sizeOf(o).height;
    s.samplesPerPixel =
        reference::showsLight(o.outputNode) || !o.all.empty() ? o.samplesPerPixel : 0;
    s.maxError = o.maxError;
    s.maxBounces = o.maxBounces.value_or(reference::kAllBounces);
    s.transport =
        o.transport == "full" ? reference::Transport::Full : reference::Transport::Diffuse;
    s.smoothIndirect = o.smoothIndirect;
    s.seed = o.seed;
    s.threads = o.threads;
    return s;
}

std::string makeReport(const ReferenceOptions& o, const reference::Rendered& rendered) {
    using Json = nlohmann::ordered_json;
    const Json bounces = o.maxBounces ? Json(*o.maxBounces) : Json(nullptr);
    const Json report{{"scene", o.scene},
                      {"size", {rendered.final.width, rendered.final.height}},
                      {"settings",
                       {{"spp", o.samplesPerPixel},
                        {"max_error", o.maxError},
                        {"max_bounces", bounces},
                        {"transport", o.transport},
                        {"smooth_indirect", o.smoothIndirect},
                        {"seed", o.seed},
                        {"camera", o.camera},
                        {"time", o.time},
                        {"output_node", o.outputNode}}},
                      {"spp", rendered.samplesPerPixel},
                      {"rays", rendered.rays},
                      {"seconds", rendered.seconds},
                      {"rays_per_second", static_cast<double>(rendered.rays) / rendered.seconds},
                      {"error", rendered.relativeError}};
    return report.dump(2) + "\n";
}

core::Result<void> checkAsked(const ReferenceOptions& o) {
    if (o.samplesPerPixel == 0) return core::error("--spp 0: a pixel needs at least one sample");
    const auto& names = reference::kImageNames;
    if (std::find(names.begin(), names.end(), o.outputNode) == names.end())
        return core::error("--output-node {}: there is no such image; there are {}", o.outputNode,
                           fmt::join(names, ", "));
    TRY_VOID(checkOutputs(o));
    if (o.all.empty()) return {};
    std::error_code code;
    std::filesystem::create_directory(o.all, code);
    if (code) return core::error("--all {}: {}", o.all.string(), code.message());
    return checkTarget(o.all / "final.exr");
}

core::Result<void> writeFiles(const ReferenceOptions& o, const reference::Rendered& rendered) {
    TRY_VOID(core::writeImage(o.output, *rendered.image(o.outputNode), o.display));
    if (!o.all.empty())
        for (const std::string_view name : reference::kImageNames)
            TRY_VOID(core::writeExr(o.all / fmt::format("{}.exr", name), *rendered.image(name)));
    if (o.report.empty()) return {};
    return core::writeFile(o.report, makeReport(o, rendered));
}

core::Result<void> render(const ReferenceOptions& o) {
    TRY_VOID(checkAsked(o));
    TRY(const ecs::World world, openWorld(o));
    const scene::SceneSnapshot snapshot = scene::extract(world, {}, 0);
    TRY(const scene::SnapshotCamera camera, chooseCamera(snapshot, o.camera));
    const auto trace = [&] {
        Progress progress{"samples a pixel", o.samplesPerPixel};
        return reference::render(snapshot, camera, settingsOf(o),
                                 [&](uint64_t done, uint64_t total) {
                                     progress.show(done * o.samplesPerPixel / total);
                                     return true;
                                 });
    };
    TRY(const reference::Rendered rendered, trace());
    core::releaseLog();
    return writeFiles(o, rendered);
}

}  // namespace

void addReference(CLI::App& program, Command& called) {
    auto* app = program.add_subcommand("reference", "The CPU reference: path tracing on all cores");
    const auto options = std::make_shared<ReferenceOptions>();
    app->add_option("scene", options->scene, "a built-in name, or a .gltf or .glb file")
        ->required();
    app->add_option("-o,--output", options->output, "the picture: EXR is linear radiance")
        ->type_name("OUT.(exr|png)")
        ->required();
    app->add_option("--spp", options->samplesPerPixel, "samples a pixel, at most (64)")
        ->check(CLI::Range(0u, reference::kMostSamplesPerPixel));
    app->add_option("--max-error", options->maxError,
                    "stop once the picture's standard error is this share of its mean (never)")
        ->check(finite(1e-9, 1e9));
    app->add_option("--max-bounces", options->maxBounces,
                    "a path hits at most one surface more; 0 is direct light (all, by roulette)")
        ->check(CLI::Range(0u, reference::kAllBounces));
    app->add_option("--transport", options->transport, "full: GGX at every bounce (diffuse)")
        ->type_name("diffuse|full")
        ->check(CLI::IsMember({"diffuse", "full"}));
    app->add_flag("--smooth-indirect", options->smoothIndirect,
                  "average indirect irradiance along surfaces where it does not vary");
    app->add_option("--threads", options->threads, "0: one a core (0)")
        ->check(CLI::Range(0u, 4096u));
    app->add_option(
           "--output-node", options->outputNode,
           fmt::format("another image: {} (final)", fmt::join(reference::kImageNames, ", ")))
        ->type_name("NAME");
    app->add_option("--all", options->all, "write every image, too, as DIR/NAME.exr")
        ->type_name("DIR");
    addSizeOptions(*app, *options);
    addViewOptions(*app, *options);
    app->callback([options, &called] {
        called.check = [options] { return checkCall(*options); };
        called.run = [options] { return render(*options); };
    });
}

}  // namespace lampyris::sandbox
