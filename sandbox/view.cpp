// `lampyris view`: frames in a window until Escape or the window manager closes it.
#include <fmt/format.h>

#include <chrono>
#include <memory>

#include "command.h"
#include "display.h"
#include "flicker/watch.h"
#include "fly_camera.h"
#include "live_budget.h"
#include "results.h"
#include "shader_watch.h"
#include "steer_player.h"
#include "window/presenter.h"

namespace lampyris::sandbox {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kDefaultScene = "cornell";
constexpr float kSecondsAcross = 8.0f;  // [chosen] to fly from one end of the scene to the other
constexpr float kLongestStep =
    0.25f;  // seconds; a slow frame does not throw the camera out of the scene
constexpr double kIdleSeconds = 0.1;
constexpr double kTimestep = 1.0 / 60.0;  // seconds a frame, where --timestep does not say

struct ViewOptions : Options {
    std::filesystem::path flicker;
    std::string shaders;
    std::optional<double> budgetMilliseconds;
};

class Viewer {
 public:
    Viewer(const ViewOptions& options, window::Window& window, FrameLoop& loop,
           window::Presenter& presenter, ShaderWatch& shaders)
        : options_(options),
          window_(window),
          loop_(loop),
          presenter_(presenter),
          shaders_(shaders),
          budget_(loop.request.settings, options.budgetMilliseconds) {}

    core::Result<void> run() {
        const uint32_t warmup = options_.warmup.value_or(0);
        if (!options_.flicker.empty()) {
            TRY(flicker::Watch watch, flicker::Watch::create(loop_.device()));
            watch_.emplace(std::move(watch));
        }
        for (uint64_t i = 0; !window_.shouldClose() && !isLast(i); ++i) {
            window_.poll();
            follow();
            shaders_.update(loop_);
            budget_.choose(loop_);
            TRY(LoopFrame frame, draw(i));
            budget_.learn(frame);
            const bool whole = frame.outcome.report.valid;
            window_.setTitle(title(frame.outcome));
            if (whole && i >= warmup && wantsMeasurements()) {
                trace_.add(frame.outcome.statistics);
                measured_.add(std::move(frame));
            }
        }
        if (watch_) {
            TRY_VOID(watch_->finish(options_.flicker));
            fmt::print("{}\n", watch_->summary());
        }
        return measured_.series.frames() > 0 ? writeResults(options_, loop_, measured_, trace_)
                                             : core::Result<void>{};
    }

 private:
    [[nodiscard]] bool isLast(uint64_t frame) const {
        return options_.frames && frame >= uint64_t{*options_.frames} + options_.warmup.value_or(0);
    }

    [[nodiscard]] bool wantsMeasurements() const {
        return !options_.report.empty() || !options_.graph.empty() || !options_.trace.empty();
    }

    /// The camera and the player follow the user, the picture the window.
    void follow() {
        const auto now = Clock::now();
        const float seconds =
            std::min(std::chrono::duration<float>(now - last_).count(), kLongestStep);
        last_ = now;
        const float across = glm::length(loop_.snapshot().boundsWorld.extent());
        auto& camera = loop_.request.camera;
        camera.cameraToWorld =
            fly(camera.cameraToWorld, window_.input(), across / kSecondsAcross, seconds);
        steerPlayer(loop_.world(), camera.cameraToWorld, window_.input(), seconds);
        const VkExtent2D size = window_.framebufferSize();
        if (size.width > 0 && size.height > 0) loop_.request.size = {size.width, size.height};
    }

    core::Result<LoopFrame> draw(uint64_t number) {
        graph::Image shown;
        const auto addNodes = [&](graph::Frame& frame, graph::Image radiance) {
            shown = addDisplay(frame, radiance, options_.display);
            frame.output(shown);
        };
        loop_.seconds =
            options_.time + static_cast<double>(number) * options_.timestep.value_or(kTimestep);
        TRY_VOID(loop_.follow());
        TRY(LoopFrame frame, loop_.tryDraw(number, false, addNodes));
        if (watch_ && frame.outcome.report.valid)
            TRY_VOID(watch_->follow(loop_, loop_.executor().outputImage(shown),
                                    frame.declared.desc(shown)));
        TRY(const window::Presented presented,
            presenter_.present(loop_.executor().outputImage(shown)));
        if (presented == window::Presented::Closed) window_.requestClose();
        if (presented == window::Presented::Skipped) window_.waitForEvents(kIdleSeconds);
        // The next frame may make its images anew while this one is still being shown.
        TRY_VOID(loop_.device().waitIdle());
        return frame;
    }

    [[nodiscard]] std::string title(const photon_gi::Renderer::Outcome& outcome) const {
        if (outcome.report.valid)
            return fmt::format("lampyris: {}, {:.1f} ms{}", options_.scene,
                               outcome.statistics.gpuMilliseconds, budget_.text());
        const shared::FrameCounters& counters = outcome.report.counters;
        return fmt::format(
            "lampyris: INVALID FRAME, {} photons, {} tile entries and {} grid cells dropped, {} in "
            "a tile",
            counters.photonsDropped, counters.pairsDropped, counters.cellsDropped,
            counters.mostInTile);
    }

    const ViewOptions& options_;
    window::Window& window_;
    FrameLoop& loop_;
    window::Presenter& presenter_;
    ShaderWatch& shaders_;
    Measured measured_;
    Trace trace_;
    LiveBudget budget_;
    std::optional<flicker::Watch> watch_;
    Clock::time_point last_ = Clock::now();
};

core::Result<void> view(const ViewOptions& options) {
    TRY_VOID(checkOutputs(options));
    TRY_VOID(checkTarget(options.flicker));
    TRY(ShaderWatch shaders, ShaderWatch::create(options.shaders));
    const graph::Extent size = sizeOf(options);
    TRY(window::Window window,
        window::Window::create({"lampyris: " + options.scene, size.width, size.height}));
    TRY(const std::unique_ptr<FrameLoop> loop, FrameLoop::open(options, true));
    TRY(window::Presenter presenter,
        window::Presenter::create(loop->device(), window, window::Encoding::Display));
    return Viewer(options, window, *loop, presenter, shaders).run();
}

}  // namespace

void addView(CLI::App& program, Command& called) {
    auto* app = program.add_subcommand("view",
                                       "Frames in a window; W A S D Q E fly, the left mouse button "
                                       "turns, the arrow keys move the player, Escape ends");
    const auto options = std::make_shared<ViewOptions>();
    options->scene = kDefaultScene;
    app->add_option("scene", options->scene, "a built-in name, or a .gltf or .glb file (cornell)");
    addFrameOptions(*app, *options);
    addPictureOptions(*app, *options);
    app->add_option("--flicker", options->flicker,
                    "write how much each frame differs from the last; prints flicker and lag")
        ->type_name("FILE.csv");
    app->add_option("--shaders", options->shaders,
                    "reload shaders when their files change (those that the program was built "
                    "from, where they are)")
        ->type_name("DIR|off");
    app->add_option("--budget-ms", options->budgetMilliseconds,
                    "keep indirect light at so many device milliseconds: gives up paths, radius, "
                    "rays and resolution as need be")
        ->check(finite(0.01, 1e6));
    app->callback([options, &called] {
        called.check = [options]() -> core::Result<void> {
            TRY_VOID(checkBudget(*options, options->budgetMilliseconds));
            return checkCall(*options);
        };
        called.run = [options] { return view(*options); };
    });
}

}  // namespace lampyris::sandbox
