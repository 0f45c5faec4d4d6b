#include "options.h"

#include <array>
#include <charconv>
#include <cmath>
#include <map>

namespace lampyris::sandbox {
namespace {

using photon_gi::Pipeline;

constexpr graph::Extent kDefaultSize{1280, 720};
constexpr uint32_t kMaxSide = 65535;   // what two 16-bit halves of a pixel's address hold
constexpr uint32_t kMaxBounces = 255;  // [chosen] far past what roulette lets live
constexpr uint32_t kMaxGatherDivisor = 16;
constexpr uint32_t kMaxGatherRays = 256;
constexpr uint32_t kMaxHistory = 4096;
constexpr uint32_t kMaxShadowRays = 31;
constexpr uint32_t kMaxFilterLevels = 5;

template <typename Enum, size_t N>
std::map<std::string, Enum> named(const std::array<const char*, N>& names) {
    std::map<std::string, Enum> choices;
    for (size_t i = 0; i < N; ++i) choices.emplace(names[i], static_cast<Enum>(i));
    return choices;
}

const auto kPipelines = named<Pipeline>(photon_gi::kPipelineNames);
const auto kGathers = named<photon_gi::Gather>(photon_gi::kGatherNames);
const auto kRetraces = named<photon_gi::Retrace>(photon_gi::kRetraceNames);
const std::map<std::string, Quality> kQualities{{"fast", Quality::Fast}, {"fine", Quality::Fine}};
const auto kTonemaps = named<core::Tonemap>(core::kTonemapNames);
const std::map<std::string, bool> kSwitch{{"on", true}, {"off", false}};

/// What follows from cost, in `full`.
struct Preset {
    uint32_t photons;
    float radiusMetres;
    uint32_t gatherDivisor;
    uint32_t gatherRays;
    uint32_t filterLevels;
    uint32_t gridColumns;
    uint32_t shadowDivisor = 4, shadowRays = 8;
};
// The Thesis's; rays and filter are for those who go on to the final gather.
constexpr Preset kTiles{1000, 1.0f, 2, 3, 2, 8};
constexpr Preset kFineTiles{100000, 0.25f, 1, 3, 2, 8};
constexpr Preset kFast{2500, 1.0f, 8, 3, 2, 8};
constexpr Preset kFine{16000, 0.5f, 4, 6, 2, 12};

template <typename T>
std::string namesOf(const std::map<std::string, T>& choices) {
    std::string names;
    for (const auto& [name, value] : choices) names += (names.empty() ? "" : "|") + name;
    return names;
}

/// One of a few words.
template <typename T, typename Target>
CLI::Option* addChoice(CLI::App& app, const std::string& flag, Target& target,
                       const std::map<std::string, T>& choices, const std::string& help) {
    const auto choose = [&target, &choices, flag](const std::string& word) {
        const auto found = choices.find(word);
        if (found == choices.end())
            throw CLI::ValidationError(flag,
                                       fmt::format("'{}' is none of {}", word, namesOf(choices)));
        target = found->second;
    };
    return app.add_option_function<std::string>(flag, choose, help)->type_name(namesOf(choices));
}

std::optional<uint32_t> parseSide(std::string_view text) {
    uint32_t side = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), side);
    if (code != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    if (side < 1 || side > kMaxSide) return std::nullopt;
    return side;
}

graph::Extent parseSize(const std::string& text) {
    const size_t cross = text.find('x');
    if (cross != std::string::npos) {
        const auto width = parseSide(std::string_view{text}.substr(0, cross));
        const auto height = parseSide(std::string_view{text}.substr(cross + 1));
        if (width && height) return {*width, *height};
    }
    throw CLI::ValidationError(
        "--size", fmt::format("'{}' is not WxH with both from 1 to {}", text, kMaxSide));
}

}  // namespace

CLI::Validator finite(double least, double most) {
    const auto check = [least, most](std::string& text) -> std::string {
        double value = 0.0;
        if (CLI::detail::lexical_cast(text, value) && value >= least && value <= most) return {};
        return fmt::format("'{}' is not a number from {} to {}", text, least, most);
    };
    return CLI::Validator(check, "NUMBER");
}

void addSizeOptions(CLI::App& app, Options& o) {
    app.add_option_function<std::string>(
           "--size", [&o](const std::string& text) { o.size = parseSize(text); },
           "pixels (1280x720)")
        ->type_name("WxH");
    app.add_option("--seed", o.seed, "of all random numbers (1)");
}

void addFrameOptions(CLI::App& app, Options& o) {
    addSizeOptions(app, o);
    app.add_option("--frames", o.frames, "frames measured (1)")->check(CLI::Range(1u, 1000000u));
    app.add_option("--warmup", o.warmup, "frames drawn before them (0)")
        ->check(CLI::Range(0u, 1000000u));
    addChoice(app, "--pipeline", o.pipeline, kPipelines,
              "full, the yardstick thesis, or direct light alone (full)");
    addChoice(app, "--quality", o.quality, kQualities,
              "preset of full: paths, rays, low resolution (fast)");
    app.add_option("--photons", o.photons,
                   "paths emitted a frame (2500; fine 16000; with tiles 1000; fine 100000)")
        ->check(CLI::Range(1u, 0xffffffffu));
    app.add_option("--radius", o.radius,
                   "metres that a photon reaches; the final gather's cells are as wide (1; "
                   "fine 0.5; fine tiles 0.25)")
        ->check(finite(1e-6, 1e6));
    app.add_option("--max-bounces", o.maxBounces,
                   "a path hits at most one surface more; 0 is direct light (full 8, thesis 1)")
        ->check(CLI::Range(0u, kMaxBounces));
    addChoice(app, "--gather", o.gather, kGathers,
              "how indirect light is looked up: photons binned to tiles, or a final gather "
              "(full: final, thesis: tiles)");
    app.add_option("--gather-rays", o.gatherRays, "final gather: rays a texel (3; fine 6)")
        ->check(CLI::Range(1u, kMaxGatherRays));
    app.add_option("--filter-levels", o.filterLevels, "final gather: levels of the filter (2)")
        ->check(CLI::Range(0u, kMaxFilterLevels));
    app.add_option("--gather-divisor", o.gatherDivisor,
                   "low resolution, an axis (8; fine 4; with tiles 2; fine 1)")
        ->check(CLI::Range(1u, kMaxGatherDivisor));
    app.add_option("--shadow-divisor", o.shadowDivisor, "low resolution of shadows, an axis (4)")
        ->check(CLI::Range(1u, kMaxGatherDivisor));
    app.add_option("--shadow-rays", o.shadowRays, "a light and low-resolution texel (8)")
        ->check(CLI::Range(1u, kMaxShadowRays));
    app.add_option("--history", o.history,
                   "final gather: frames in the mean while nothing changes; 0 is off (80; 1 "
                   "without --reseed)")
        ->check(CLI::Range(0u, kMaxHistory));
    addChoice(app, "--guiding", o.guiding, kSwitch,
              "final gather: send photons where earlier frames looked them up (on)");
    addChoice(app, "--reseed", o.reseed, kSwitch, "draw a frame's paths anew every frame (on)");
    addChoice(app, "--retrace", o.retrace, kRetraces,
              "full's final gather: keep what cannot have changed since the frame before (auto)");
    app.add_option("--light-cutoff", o.lightCutoff,
                   "share of the mean direct irradiance under which a light's reach ends (0.001)")
        ->check(finite(0.0, 1e6));
    app.add_flag("--validation", o.validation, "Vulkan core and synchronization validation");
    app.add_option("--device", o.device, "part of the device's name (the best there is)")
        ->type_name("SUBSTRING");
}

void addDisplayOptions(CLI::App& app, core::DisplayTransform& display) {
    app.add_option("--exposure", display.exposureEv,
                   fmt::format("EV; display only ({:g})", display.exposureEv))
        ->check(finite(-100.0, 100.0));
    addChoice(app, "--tonemap", display.tonemap, kTonemaps, "display only (clip)");
}

void addCameraOptions(CLI::App& app, Options& o) {
    app.add_option("--camera", o.camera, "by name (the first)")->type_name("NAME");
    app.add_option("--animation", o.animation, "by name (the first)")->type_name("NAME");
    app.add_option("--time", o.time, "seconds, of the first frame (0)")->check(finite(-1e6, 1e6));
}

void addViewOptions(CLI::App& app, Options& o) {
    addCameraOptions(app, o);
    addDisplayOptions(app, o.display);
    app.add_option("--report", o.report, "write measurements")->type_name("FILE.json");
}

void addPictureOptions(CLI::App& app, Options& o) {
    addViewOptions(app, o);
    app.add_option("--timestep", o.timestep, "seconds a frame (0; in view 1/60)")
        ->check(finite(0.0, 1e6));
    app.add_option("--graph", o.graph, "write the render graph")->type_name("FILE.(dot|json)");
    app.add_option("--trace", o.trace, "write times in Chrome's trace format")
        ->type_name("FILE.json");
}

photon_gi::Settings settingsOf(const Options& o) {
    const bool thesis = o.pipeline == Pipeline::Thesis;
    const auto gather =
        thesis ? photon_gi::Gather::Tiles : o.gather.value_or(photon_gi::Gather::Final);
    const bool tiles = gather == photon_gi::Gather::Tiles;
    const Preset fine = tiles ? kFineTiles : kFine;
    const Preset preset = !thesis && o.quality == Quality::Fine ? fine : tiles ? kTiles : kFast;
    photon_gi::Settings s;
    s.pipeline = o.pipeline;
    s.photonPaths = o.photons.value_or(preset.photons);
    s.radiusMetres = o.radius.value_or(preset.radiusMetres);
    s.gatherDivisor = o.gatherDivisor.value_or(preset.gatherDivisor);
    s.gather = gather;
    s.history = gather == photon_gi::Gather::Final ? o.history.value_or(s.history) : 0;
    s.gridColumns = preset.gridColumns;
    s.gatherRays = o.gatherRays.value_or(preset.gatherRays);
    s.shadowDivisor = o.shadowDivisor.value_or(preset.shadowDivisor);
    s.shadowRays = o.shadowRays.value_or(preset.shadowRays);
    s.filterLevels = o.filterLevels.value_or(preset.filterLevels);
    s.maxBounces = o.maxBounces.value_or(thesis ? 1 : 8);
    s.lightCutoff = o.lightCutoff;
    s.seed = o.seed;
    s.reseed = o.reseed;
    s.retrace = o.retrace.value_or(photon_gi::Retrace::Auto);
    s.guiding = o.guiding.value_or(true);
    return s;
}

graph::Extent sizeOf(const Options& o) {
    return o.size.value_or(kDefaultSize);
}

const char* name(Quality quality) {
    return quality == Quality::Fine ? "fine" : "fast";
}

}  // namespace lampyris::sandbox
