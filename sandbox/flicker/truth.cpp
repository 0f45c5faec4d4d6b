#include "flicker/truth.h"

#include "core/image_io.h"
#include "progress.h"
#include "reference/reference.h"
#include "thesis/content_id.h"

namespace lampyris::sandbox::flicker {
namespace {

constexpr graph::Extent kProbeSize{64, 36};
constexpr uint32_t kProbeSamples = 4;  // [chosen] the picture itself takes a hundred times as long

uint64_t versionOf(const scene::SceneSnapshot& snapshot) {
    return snapshot.geometryVersion + snapshot.lightVersion + snapshot.materialVersion;
}

bool isOfSize(const core::Image& image, graph::Extent size) {
    return image.width == size.width && image.height == size.height;
}

}  // namespace

core::Result<Truths> Truths::open(const Call& call) {
    Truths truths;
    truths.call_ = &call;
    Options options = call.options;
    options.size = call.stillSize();
    TRY(truths.loop_, FrameLoop::open(options));
    return truths;
}

core::Result<core::Image> Truths::render(graph::Extent size, uint32_t samples, uint32_t seed) {
    reference::Settings settings;
    settings.width = size.width;
    settings.height = size.height;
    settings.samplesPerPixel = samples;
    settings.smoothIndirect = true;
    settings.seed = seed;
    TRY(auto rendered, reference::render(loop_->snapshot(), loop_->request.camera, settings));
    return std::move(rendered.final);
}

core::Result<core::Image> Truths::renderKept(graph::Extent size, uint32_t samples, uint32_t seed) {
    if (call_->out.empty()) return render(size, samples, seed);
    TRY(const core::Image probe, render(kProbeSize, kProbeSamples, seed));
    const auto name = fmt::format("flicker-reference-{}-{}x{}-{}-{}.exr", thesis::idOf(probe),
                                  size.width, size.height, samples, seed);
    const auto kept = core::readExr(call_->out / name);
    if (kept.ok() && isOfSize(*kept, size)) return *kept;
    TRY(core::Image image, render(size, samples, seed));
    TRY_VOID(core::writeExr(call_->out / name, image));
    return image;
}

core::Result<const evaluation::Picture*> Truths::still() {
    if (still_) return &*still_;
    const graph::Extent size = call_->stillSize();
    core::Image image;
    if (!call_->reference.empty()) {
        TRY(image, core::readExr(call_->reference));
    } else {
        const Progress progress{"reference", 1};
        loop_->seconds = call_->options.time;
        TRY_VOID(loop_->follow());
        TRY(image,
            renderKept(size, call_->samplesPerPixel.value_or(kStillSamples), call_->options.seed));
    }
    if (!isOfSize(image, size))
        return core::error("{}: is {}x{}, the frames are {}x{}", call_->reference.string(),
                           image.width, image.height, size.width, size.height);
    TRY(still_, evaluation::fromLinear("the reference", image, call_->options.display));
    return &*still_;
}

double Truths::secondsOf(uint32_t movingFrame) const {
    return call_->options.time +
           static_cast<double>(call_->warmup() + movingFrame) * call_->timestep();
}

core::Result<bool> Truths::moves() {
    loop_->seconds = secondsOf(0);
    TRY_VOID(loop_->follow());
    const uint64_t first = versionOf(loop_->snapshot());
    for (uint32_t i = 1; i < call_->movingFrames(); ++i) {
        loop_->seconds = secondsOf(i);
        TRY_VOID(loop_->follow());
    }
    return versionOf(loop_->snapshot()) != first;
}

core::Result<std::vector<core::DisplayImage>> Truths::sequence(uint32_t seed) {
    Progress progress{"frame of the reference", call_->movingFrames()};
    std::vector<core::DisplayImage> frames;
    for (uint32_t i = 0; i < call_->movingFrames(); ++i) {
        progress.show(i);
        loop_->seconds = secondsOf(i);
        TRY_VOID(loop_->follow());
        const uint32_t samples = call_->samplesPerPixel.value_or(kMovingSamples);
        TRY(const core::Image image, renderKept(call_->movingSize(), samples, seed));
        frames.push_back(core::toDisplay(image, call_->options.display));
    }
    return frames;
}

core::Result<const MovingTruth*> Truths::moving() {
    if (!lookedForMotion_) {
        lookedForMotion_ = true;
        TRY(const bool moving, moves());
        if (moving) {
            MovingTruth truth;
            TRY(truth.frames, sequence(2 * call_->options.seed));
            TRY(const auto other, sequence(2 * call_->options.seed + 1));
            TRY(truth.floor, evaluation::dynamicFlicker(truth.frames, other));
            moving_ = std::move(truth);
        }
    }
    return moving_ ? &*moving_ : nullptr;
}

}  // namespace lampyris::sandbox::flicker
