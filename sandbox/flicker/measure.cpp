#include "flicker/measure.h"

#include <array>

#include "camera_choice.h"
#include "core/log.h"
#include "evaluation/mssim.h"
#include "evaluation/plane.h"
#include "open_world.h"
#include "progress.h"
#include "reference/reference.h"
#include "scene/extract.h"

namespace lampyris::sandbox::flicker {
namespace {

constexpr graph::Extent kMovingSize{320, 180};  // [DESIGN] of dynamic flicker
constexpr uint32_t kMovingFrames = 32;
constexpr uint32_t kStillFrames = 64;
constexpr uint32_t kBeyondHistory = 8;  // [chosen] frames of warm-up after the mean is full
constexpr double kStep = 1.0 / 60.0;

/// Every frame's paths are its own, and all of them are traced.
Options anew(Options options, bool reseed) {
    options.reseed = reseed;
    if (!reseed) options.guiding.reset();
    options.retrace = photon_gi::Retrace::All;
    options.timestep = 0.0;
    options.outputNode = "final";
    return options;
}

uint32_t warmupOf(const Options& options) {
    return options.warmup.value_or(settingsOf(options).history + kBeyondHistory);
}

core::Result<core::Image> drawReference(const scene::SceneSnapshot& snapshot,
                                        const scene::SnapshotCamera& camera, graph::Extent size,
                                        uint32_t samples, uint32_t seed) {
    reference::Settings settings;
    settings.width = size.width;
    settings.height = size.height;
    settings.samplesPerPixel = samples;
    settings.smoothIndirect = true;
    settings.seed = seed;
    TRY(auto rendered, reference::render(snapshot, camera, settings));
    return std::move(rendered.final);
}

/// Both sequences of the reference, with the same random numbers in each frame.
core::Result<void> drawMovingTruth(const FlickerCall& call, const Moving& moving, Truths& truths) {
    Progress progress{"reference frame", 2 * moving.frames.size()};
    uint64_t done = 0;
    for (uint32_t i = 0; i < 2; ++i)
        for (const MovingFrame& frame : moving.frames) {
            progress.show(done++);
            TRY(const core::Image image,
                drawReference(frame.snapshot, frame.camera, kMovingSize, call.movingSamplesPerPixel,
                              2 * call.options.seed + i));
            truths.moving[i].push_back(core::toDisplay(image, call.options.display));
        }
    TRY(const auto floor, evaluation::dynamicFlicker(truths.moving[0], truths.moving[1]));
    truths.floor = floor.mean;
    return {};
}

core::Result<void> measureStill(const FlickerCall& call, const Options& options,
                                const Truths& truths, FrameLoop& loop, uint64_t& frameNumber,
                                FlickerFigures& figures) {
    const core::DisplayTransform& display = call.options.display;
    TRY(const Pictures pictures, drawStill(loop, display, warmupOf(options),
                                           options.frames.value_or(kStillFrames), frameNumber));
    evaluation::StillSequence sequence;
    for (const auto& picture : pictures) TRY_VOID(sequence.add(picture));
    TRY(figures.still, sequence.flicker());
    for (size_t t = 1; t < pictures.size(); ++t) {
        const auto a = evaluation::lumaOf(pictures[t]), b = evaluation::lumaOf(pictures[t - 1]);
        double sum = 0.0;
        for (size_t i = 0; i < a.values.size(); ++i) sum += std::abs(a.values[i] - b.values[i]);
        figures.stillFrames.push_back(sum / static_cast<double>(a.values.size()));
    }
    const auto average = evaluation::fromDisplay("the averaged frame", figures.still.average);
    TRY(const auto truth, evaluation::fromLinear("the reference", truths.still, display));
    TRY(const auto mssim, evaluation::mssim(average, truth));
    figures.mssim = mssim.value;
    return {};
}

core::Result<void> measureFrozen(const FlickerCall& call, const Options& options,
                                 FlickerFigures& figures) {
    const Options frozen = anew(options, false);
    TRY(const auto loop, FrameLoop::open(frozen));
    uint64_t frameNumber = 0;
    TRY(const Pictures pictures, drawStill(*loop, call.options.display, 2, 4, frameNumber));
    evaluation::StillSequence sequence;
    for (const auto& picture : pictures) TRY_VOID(sequence.add(picture));
    TRY(const auto flicker, sequence.flicker());
    figures.frozen = flicker.mean;
    return {};
}

core::Result<void> measureMoving(const FlickerCall& call, const Options& options, Truths& truths,
                                 FlickerFigures& figures) {
    Options moving = anew(options, true);
    moving.size = kMovingSize;
    moving.timestep = options.timestep.value_or(kStep);
    TRY(const auto loop, FrameLoop::open(moving));
    TRY(const Moving drawn,
        drawMoving(*loop, call.options.display, warmupOf(moving), kMovingFrames));
    figures.moves = drawn.moves;
    if (!drawn.moves) return {};
    if (truths.moving[0].empty()) TRY_VOID(drawMovingTruth(call, drawn, truths));
    TRY(figures.dynamic, evaluation::dynamicFlicker(drawn.pictures, truths.moving[0]));
    return {};
}

}  // namespace

core::Result<core::Image> stillTruth(const FlickerCall& call) {
    TRY(const ecs::World world, openWorld(call.options));
    const scene::SceneSnapshot snapshot = scene::extract(world, {}, 0);
    TRY(const auto camera, chooseCamera(snapshot, call.options.camera));
    core::releaseLog();
    return drawReference(snapshot, camera, sizeOf(call.options), call.samplesPerPixel,
                         call.options.seed);
}

core::Result<FlickerFigures> measure(const FlickerCall& call, const Options& options,
                                     Truths& truths, bool whole) {
    const photon_gi::Settings settings = settingsOf(options);
    FlickerFigures figures;
    figures.name = sandbox::name(options.pipeline);
    figures.photons = settings.photonPaths;
    figures.radiusMetres = settings.radiusMetres;
    const Options fresh = anew(options, true);
    TRY(const auto loop, FrameLoop::open(fresh));
    uint64_t frameNumber = 0;
    TRY_VOID(measureStill(call, fresh, truths, *loop, frameNumber, figures));
    for (const LightChange change : {LightChange::Off, LightChange::On, LightChange::Moved}) {
        if (!whole && change != LightChange::Off) break;
        TRY(const Pictures pictures, drawChange(*loop, call.options.display, change, frameNumber));
        if (pictures.empty()) continue;
        TRY(figures.lags[nameOf(change)], evaluation::lagOf(pictures));
    }
    if (!whole) return figures;
    TRY_VOID(measureFrozen(call, options, figures));
    TRY_VOID(measureMoving(call, options, truths, figures));
    return figures;
}

}  // namespace lampyris::sandbox::flicker
