#include "reference/reference.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <new>

#include "reference/film.h"
#include "reference/parallel.h"

namespace lampyris::reference {
namespace {

constexpr uint32_t kTile = 16;  // pixels a side that one thread takes at a time [chosen]
// Samples of a pixel between two looks at the error. [chosen: a sixteenth of the usual 256]
constexpr uint32_t kRound = 16;

/// Bytes that a pixel needs while it is rendered and developed: images of 28 floats in all.
constexpr uint64_t kPixelBytes = sizeof(PixelSums) + sizeof(PixelGuide) + 28 * sizeof(float);

core::Result<void> checkMemory(const Settings& settings) {
    const uint64_t needed = uint64_t{settings.width} * settings.height * kPixelBytes;
    const uint64_t there = static_cast<uint64_t>(::sysconf(_SC_PHYS_PAGES)) *
                           static_cast<uint64_t>(::sysconf(_SC_PAGE_SIZE));
    if (needed <= there) return {};
    return core::error("a picture of {}x{} takes {} MiB, the machine has {}", settings.width,
                       settings.height, needed >> 20u, there >> 20u);
}

/// Tells one thread at a time how far all have come, and hears whether to go on.
class Meter {
 public:
    Meter(const ProgressFunction& tell, uint64_t total) : tell_(tell), total_(total) {}
    void add(uint64_t samples) {
        if (!tell_ || total_ == 0) return;
        const std::lock_guard lock(mutex_);
        done_ += samples;
        if (!tell_(std::min(done_, total_), total_)) stopped_ = true;
    }
    [[nodiscard]] bool stopped() const { return stopped_; }

 private:
    const ProgressFunction& tell_;
    std::mutex mutex_;
    uint64_t done_ = 0, total_;
    std::atomic<bool> stopped_{false};
};

class Render {
 public:
    Render(const Stage& stage, const scene::SnapshotCamera& camera, const Settings& settings,
           const ProgressFunction& progress)
        : stage_(stage),
          settings_(settings),
          camera_(camera, settings.width, settings.height),
          sequences_(std::clamp(settings.samplesPerPixel, 1u, kSequences)),
          film_(settings.width, settings.height, sequences_),
          meter_(progress, uint64_t{settings.width} * settings.height * settings.samplesPerPixel) {}

    core::Result<Rendered> run() {
        const auto start = std::chrono::steady_clock::now();
        uint32_t taken = 0;
        do {
            const uint32_t until = std::min(taken + kRound, settings_.samplesPerPixel);
            takeRound(taken, until);
            if (meter_.stopped()) return core::error("the reference was stopped");
            taken = until;
        } while (taken < settings_.samplesPerPixel && !goodEnough(taken));
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        Rendered rendered = film_.develop(taken, camera_, settings_);
        rendered.rays = rays_;
        rendered.seconds = seconds.count();
        return rendered;
    }

 private:
    [[nodiscard]] bool goodEnough(uint32_t taken) const {
        return settings_.maxError > 0.0f &&
               film_.relativeError(taken) <= static_cast<double>(settings_.maxError);
    }

    /// Adds samples `first` up to `last` of every pixel.
    void takeRound(uint32_t first, uint32_t last) {
        const uint32_t columns = (settings_.width + kTile - 1) / kTile;
        const uint32_t rows = (settings_.height + kTile - 1) / kTile;
        shareOut(columns * rows, settings_.threads, [&](uint32_t tile) {
            if (meter_.stopped()) return;
            PathTracer tracer(stage_, settings_.maxBounces, settings_.transport);
            const uint32_t left = tile % columns * kTile, top = tile / columns * kTile;
            const uint32_t right = std::min(left + kTile, settings_.width);
            const uint32_t bottom = std::min(top + kTile, settings_.height);
            for (uint32_t y = top; y < bottom; ++y)
                for (uint32_t x = left; x < right; ++x) takePixel(tracer, x, y, first, last);
            rays_ += tracer.rays() + uint64_t{right - left} * (bottom - top);
            meter_.add(uint64_t{right - left} * (bottom - top) * (last - first));
        });
    }

    void takePixel(PathTracer& tracer, uint32_t x, uint32_t y, uint32_t first, uint32_t last) {
        const size_t pixel = size_t{y} * settings_.width + x;
        const Pixel seen = lookThrough(stage_, camera_.through(x, y));
        if (first == 0) film_.setGuide(pixel, seen);
        if (!seen.surface) return;
        const PathTracer::Seen point = tracer.look(*seen.surface, seen.toEye);
        const uint32_t seed = mixSeeds(mixSeeds(settings_.seed, x), y);
        for (uint32_t i = first; i < last; ++i) {
            const uint32_t sequence = i % sequences_;
            const OwenSobol numbers(mixSeeds(seed, sequence), i / sequences_);
            film_.add(pixel, sequence, tracer.sample(point, numbers));
        }
    }

    Stage stage_;
    Settings settings_;
    PixelRays camera_;
    uint32_t sequences_;
    Film film_;
    Meter meter_;
    std::atomic<uint64_t> rays_{0};
};

}  // namespace

const core::Image* Rendered::image(std::string_view name) const {
    const std::array<const core::Image*, kImageNames.size()> images{
        &final,    &direct, &indirect, &irradianceDirect, &irradianceIndirect, &albedo, &normal,
        &position, &depth,  &error};
    const auto* found = std::find(kImageNames.begin(), kImageNames.end(), name);
    return found == kImageNames.end() ? nullptr
                                      : images[static_cast<size_t>(found - kImageNames.begin())];
}

bool showsLight(std::string_view name) {
    return name != "albedo" && name != "normal" && name != "position" && name != "depth";
}

struct BuiltScene::Parts {
    explicit Parts(RayScene built)
        : scene(std::move(built)), lights(scene.snapshot()), emitters(scene) {}
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;

    RayScene scene;
    SphereLights lights;
    Emitters emitters;  ///< refers to the scene beside it
};

BuiltScene::BuiltScene(std::unique_ptr<const Parts> parts) : parts_(std::move(parts)) {}
BuiltScene::~BuiltScene() = default;
BuiltScene::BuiltScene(BuiltScene&&) noexcept = default;
BuiltScene& BuiltScene::operator=(BuiltScene&&) noexcept = default;

core::Result<BuiltScene> BuiltScene::build(const scene::SceneSnapshot& snapshot) {
    try {
        TRY(RayScene scene, RayScene::build(snapshot));
        return BuiltScene{std::make_unique<const Parts>(std::move(scene))};
    } catch (const std::bad_alloc&) {
        return core::error("a scene of {} instances does not fit into memory",
                           snapshot.instances.size());
    }
}

core::Result<Rendered> BuiltScene::render(const scene::SnapshotCamera& camera,
                                          const Settings& settings,
                                          const ProgressFunction& progress) const {
    TRY_VOID(checkMemory(settings));
    try {
        const Stage stage{&parts_->scene, &parts_->lights, &parts_->emitters};
        return Render(stage, camera, settings, progress).run();
    } catch (const std::bad_alloc&) {
        return core::error("a picture of {}x{} and its scene do not fit into memory",
                           settings.width, settings.height);
    }
}

core::Result<Rendered> render(const scene::SceneSnapshot& snapshot,
                              const scene::SnapshotCamera& camera, const Settings& settings,
                              const ProgressFunction& progress) {
    TRY_VOID(checkMemory(settings));  // before the scene is built
    TRY(const BuiltScene scene, BuiltScene::build(snapshot));
    return scene.render(camera, settings, progress);
}

}  // namespace lampyris::reference
