#include "overlay/truth_worker.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

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
    if (frame.before.bytes.empty() || frame.before.desc.extent != frame.radiance.desc.extent)
        return std::optional<double>{};
    TRY(const auto before,
        evaluation::fromLinear("frame before", execute::toImage(frame.before), frame.display));
    evaluation::FlickerMeter meter;
    TRY_VOID(meter.add(before.display));
    TRY_VOID(meter.add(now.display));
    return std::optional{meter.changes().back()};
}

struct Measurement {
    TruthFigures figures;
    std::shared_ptr<const core::DisplayImage> reference, difference;
};

core::Result<Measurement> measureAgainst(const TruthFrame& frame, const core::Image& truth) {
    TRY(const auto picture,
        evaluation::fromLinear("frame", execute::toImage(frame.radiance), frame.display));
    TRY(auto reference, evaluation::fromLinear("reference", truth, frame.display));
    TRY(const auto compared, evaluation::compare(picture, reference));
    TRY(const auto change, changeOf(frame, picture));
    Measurement made;
    made.figures = {compared.mse.value, compared.mssim.value, compared.flip.value,
                    compared.relMse.value, change};
    made.difference = std::make_shared<const core::DisplayImage>(
        differenceOf(picture.display, reference.display));
    made.reference = std::make_shared<const core::DisplayImage>(std::move(reference.display));
    return made;
}

}  // namespace

TruthKey::TruthKey(const TruthView& view)
    : geometryVersion(view.snapshot.geometryVersion),
      lightVersion(view.snapshot.lightVersion),
      materialVersion(view.snapshot.materialVersion),
      cameraToWorld(view.camera.cameraToWorld),
      verticalFovRadians(view.camera.verticalFovRadians),
      width(view.width),
      height(view.height),
      maxBounces(view.maxBounces) {}

bool TruthKey::sameScene(const TruthKey& o) const {
    return geometryVersion == o.geometryVersion && lightVersion == o.lightVersion &&
           materialVersion == o.materialVersion;
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

bool TruthWorker::follow(const TruthView& view) {
    const TruthKey key(view);
    const bool same = key_ == key;
    std::shared_ptr<const Task> begins;
    if (!same) {
        key_ = key;
        stood_ = 0;
    } else if (stood_ < kStandingFrames && ++stood_ == kStandingFrames) {
        begins = std::make_shared<const Task>(Task{key, view.snapshot, view.camera});
    }
    {
        const std::scoped_lock lock(mutex_);
        const bool rested = std::exchange(rests_, false);
        if (!same) {
            task_.reset();
            ++views_;
            dropFigures();
            state_.samples = 0;
            state_.relativeError = state_.seconds = 0.0;
            state_.error.clear();
        }
        if (begins)
            task_ = std::move(begins);
        else if (!rested)
            return same;
    }
    wake_.notify_all();
    return same;
}

void TruthWorker::rest() {
    const std::scoped_lock lock(mutex_);
    rests_ = true;
    frame_.reset();
}

bool TruthWorker::wantsFrame() const {
    const std::scoped_lock lock(mutex_);
    return !frame_ && state_.samples > 0;
}

void TruthWorker::measure(TruthFrame frame) {
    {
        const std::scoped_lock lock(mutex_);
        frame_ = std::move(frame);
    }
    wake_.notify_all();
}

void TruthWorker::forgetFigures() {
    const std::scoped_lock lock(mutex_);
    dropFigures();
}

void TruthWorker::dropFigures() {
    ++series_;
    frame_.reset();
    state_.figures.clear();
    state_.measureError.clear();
    state_.reference.reset();
    state_.difference.reset();
    ++state_.pictures;
}

TruthState TruthWorker::state() const {
    const std::scoped_lock lock(mutex_);
    return state_;
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
    if (!task_ || rests_ || !state_.error.empty() || state_.samples >= kMostSamples) return false;
    const std::shared_ptr<const Task> task = task_;
    const uint64_t asked = views_;
    reference::Settings settings;
    settings.width = task->key.width;
    settings.height = task->key.height;
    settings.maxBounces = task->key.maxBounces;
    settings.seed = state_.samples + 1;
    settings.threads = 1;
    const double each = state_.samples > 0 ? state_.seconds / state_.samples : kRoundSeconds;
    settings.samplesPerPixel = std::clamp(
        static_cast<uint32_t>(kRoundSeconds / std::max(each, 1e-3)), kLeastRound, kMostRound);
    lock.unlock();
    bool stopped = false;
    const auto wanted = [&](uint64_t, uint64_t) {
        const std::scoped_lock held(mutex_);
        stopped = ends_ || rests_ || asked != views_;
        return !stopped;
    };
    const auto built = build(*task);
    const auto begin = Clock::now();  // behind the building, which no further round has
    const auto rendered =
        built.ok() ? scene_->render(task->camera, settings, wanted) : built.error();
    const double seconds = secondsSince(begin);
    if (rendered.ok()) {
        if (std::exchange(sumOf_, asked) != asked) sum_ = {};  // of nobody but this thread
        addWeighted(sum_, rendered->final, static_cast<float>(rendered->samplesPerPixel));
    }
    lock.lock();
    if (stopped || ends_ || asked != views_) return true;  // another view, or none, by now
    if (!rendered.ok()) {
        state_.error = rendered.error().message;
        return false;
    }
    const uint32_t taken = rendered->samplesPerPixel;
    state_.samples += taken;
    state_.relativeError =
        rendered->relativeError * std::sqrt(static_cast<double>(taken) / state_.samples);
    state_.seconds += seconds;
    return true;
}

core::Result<void> TruthWorker::build(const Task& task) {
    if (scene_ && builtFrom_->sameScene(task.key)) return {};
    scene_.reset();  // before the next one takes memory
    TRY(scene_, reference::BuiltScene::build(task.snapshot));
    builtFrom_ = task.key;
    return {};
}

void TruthWorker::measureNow(std::unique_lock<std::mutex>& lock) {
    const TruthFrame frame = std::move(*frame_);
    frame_.reset();
    const uint64_t asked = series_;
    const uint32_t samples = state_.samples;
    lock.unlock();
    auto measured = measureAgainst(frame, scaled(sum_, 1.0f / static_cast<float>(samples)));
    lock.lock();
    if (asked != series_) return;
    state_.measureError = measured.ok() ? std::string{} : measured.error().message;
    if (!measured.ok()) return;
    state_.figures.push_back(measured->figures);
    if (state_.figures.size() > kMostFigures) state_.figures.erase(state_.figures.begin());
    state_.reference = std::move(measured->reference);
    state_.difference = std::move(measured->difference);
    ++state_.pictures;
}

}  // namespace lampyris::overlay
