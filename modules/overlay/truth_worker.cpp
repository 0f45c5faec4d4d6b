#include "overlay/truth_worker.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "evaluation/flicker.h"

namespace lampyris::overlay {
namespace {

using Clock = std::chrono::steady_clock;

constexpr uint32_t kMostSamples = 4096;  // [chosen] noise is then far under a display's steps
constexpr double kRoundSeconds = 1.0;    // [chosen] a moved camera waits no longer for its truth
constexpr uint32_t kLeastRound = 2;      // samples: one has no deviation
constexpr uint32_t kMostRound = 64;
constexpr size_t kMostFigures = 240;
constexpr int kDifferenceGain = 4;  // [chosen] 64 of 255 is white

double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// sum + image · weight.
void addWeighted(core::Image& sum, const core::Image& image, float weight) {
    if (sum.values.empty()) sum = core::Image(image.width, image.height, image.channels);
    for (size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += weight * image.values[i];
}

core::Image scaled(const core::Image& image, float factor) {
    core::Image result = image;
    for (float& value : result.values) value *= factor;
    return result;
}

core::DisplayImage differenceOf(const core::DisplayImage& a, const core::DisplayImage& b) {
    core::DisplayImage result = a;
    for (size_t i = 0; i < result.values.size(); ++i)
        result.values[i] = static_cast<uint8_t>(
            std::min(255, kDifferenceGain * std::abs(int{a.values[i]} - int{b.values[i]})));
    return result;
}

/// [F3] between two frames; none where the first is empty or of another size.
core::Result<std::optional<double>> changeOf(const TruthFrame& frame,
                                             const evaluation::Picture& now) {
    if (frame.before.width != frame.radiance.width || frame.before.height != frame.radiance.height)
        return std::optional<double>{};
    TRY(const auto before, evaluation::fromLinear("frame before", frame.before, frame.display));
    evaluation::FlickerMeter meter;
    TRY_VOID(meter.add(before.display));
    TRY_VOID(meter.add(now.display));
    return std::optional{meter.changes().back()};
}

struct Measurement {
    TruthFigures figures;
    core::DisplayImage reference, difference;
};

core::Result<Measurement> measureAgainst(const TruthFrame& frame, const core::Image& truth) {
    TRY(const auto picture, evaluation::fromLinear("frame", frame.radiance, frame.display));
    TRY(const auto reference, evaluation::fromLinear("reference", truth, frame.display));
    TRY(const auto compared, evaluation::compare(picture, reference));
    TRY(const auto change, changeOf(frame, picture));
    Measurement made;
    made.figures = {compared.mse.value, compared.mssim.value, compared.flip.value,
                    compared.relMse.value, change};
    made.difference = differenceOf(picture.display, reference.display);
    made.reference = reference.display;
    return made;
}

}  // namespace

bool TruthView::sameAs(const TruthView& o) const {
    return width == o.width && height == o.height && maxBounces == o.maxBounces &&
           snapshot.geometryVersion == o.snapshot.geometryVersion &&
           snapshot.lightVersion == o.snapshot.lightVersion &&
           snapshot.materialVersion == o.snapshot.materialVersion &&
           camera.cameraToWorld == o.camera.cameraToWorld &&
           camera.verticalFovRadians == o.camera.verticalFovRadians;
}

TruthWorker::TruthWorker() : thread_([this] { run(); }) {}

TruthWorker::~TruthWorker() {
    {
        const std::scoped_lock lock(mutex_);
        ends_ = true;
    }
    wake_.notify_all();
    thread_.join();
}

void TruthWorker::follow(const TruthView& view) {
    {
        const std::scoped_lock lock(mutex_);
        if (view_ && view_->sameAs(view)) return;
        view_ = view;
        ++views_;
        frame_.reset();
        sum_ = {};
        state_ = {};
    }
    wake_.notify_all();
}

void TruthWorker::rest() {
    const std::scoped_lock lock(mutex_);
    if (!view_) return;
    view_.reset();
    ++views_;
    frame_.reset();
}

bool TruthWorker::wantsFrame() const {
    const std::scoped_lock lock(mutex_);
    return view_ && !frame_ && state_.samples > 0;
}

void TruthWorker::measure(TruthFrame frame) {
    {
        const std::scoped_lock lock(mutex_);
        frame_ = std::move(frame);
    }
    wake_.notify_all();
}

TruthState TruthWorker::state() const {
    const std::scoped_lock lock(mutex_);
    return state_;
}

TruthState TruthWorker::figures() const {
    const std::scoped_lock lock(mutex_);
    TruthState state;
    state.samples = state_.samples;
    state.relativeError = state_.relativeError;
    state.seconds = state_.seconds;
    state.figures = state_.figures;
    state.pictures = state_.pictures;
    state.error = state_.error;
    return state;
}

void TruthWorker::run() {
    std::unique_lock lock(mutex_);
    while (!ends_) {
        // In turn, so that neither starves the other.
        const bool measured = frame_ && state_.samples > 0;
        if (measured) measureNow(lock);
        if (!ends_ && !refine(lock) && !measured) wake_.wait(lock);
    }
}

/// False where there is nothing to refine.
bool TruthWorker::refine(std::unique_lock<std::mutex>& lock) {
    if (!view_ || !state_.error.empty() || state_.samples >= kMostSamples) return false;
    const TruthView view = *view_;
    const uint64_t asked = views_;
    reference::Settings settings;
    settings.width = view.width;
    settings.height = view.height;
    settings.maxBounces = view.maxBounces;
    settings.seed = state_.samples + 1;
    settings.threads = 1;
    const double each = state_.samples > 0 ? state_.seconds / state_.samples : kRoundSeconds;
    settings.samplesPerPixel = std::clamp(
        static_cast<uint32_t>(kRoundSeconds / std::max(each, 1e-3)), kLeastRound, kMostRound);
    lock.unlock();
    const auto begin = Clock::now();
    const auto wanted = [&](uint64_t, uint64_t) {
        const std::scoped_lock held(mutex_);
        return !ends_ && asked == views_;
    };
    const auto rendered = reference::render(view.snapshot, view.camera, settings, wanted);
    const double seconds = secondsSince(begin);
    lock.lock();
    if (ends_ || asked != views_) return true;  // it is another view by now
    if (!rendered.ok()) {
        state_.error = rendered.error().message;
        return false;
    }
    const reference::Rendered& round = rendered.value();
    addWeighted(sum_, round.final, static_cast<float>(round.samplesPerPixel));
    state_.samples += round.samplesPerPixel;
    state_.relativeError = round.relativeError *
                           std::sqrt(static_cast<double>(round.samplesPerPixel) / state_.samples);
    state_.seconds += seconds;
    return true;
}

void TruthWorker::measureNow(std::unique_lock<std::mutex>& lock) {
    const TruthFrame frame = std::move(*frame_);
    frame_.reset();
    const uint64_t asked = views_;
    const core::Image truth = scaled(sum_, 1.0f / static_cast<float>(state_.samples));
    lock.unlock();
    auto measured = measureAgainst(frame, truth);
    lock.lock();
    if (asked != views_) return;
    if (!measured.ok()) {
        state_.error = measured.error().message;
        return;
    }
    state_.figures.push_back(measured.value().figures);
    if (state_.figures.size() > kMostFigures) state_.figures.erase(state_.figures.begin());
    state_.reference = std::move(measured.value().reference);
    state_.difference = std::move(measured.value().difference);
    ++state_.pictures;
}

}  // namespace lampyris::overlay
