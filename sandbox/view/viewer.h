/// \file The loop of `lampyris view`: input, edits, the overlay, a frame, the window.
#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include "flicker/watch.h"
#include "frame_loop.h"
#include "live_budget.h"
#include "overlay/overlay.h"
#include "overlay/panels.h"
#include "results.h"
#include "shader_watch.h"
#include "view/edits.h"
#include "view/frame_rate.h"
#include "view/input_log.h"
#include "view/last_drawn.h"
#include "view/settings_file.h"
#include "view/view_options.h"
#include "view/walk_camera.h"
#include "window/presenter.h"

namespace lampyris::sandbox::view {

class Viewer {
 public:
    /// All must outlive it.
    Viewer(const ViewOptions& options, window::Window& window, FrameLoop& loop,
           window::Presenter& presenter, ShaderWatch& shaders);

    /// Until the window is closed, the replay is over or --frames are drawn.
    core::Result<void> run();

    [[nodiscard]] ViewState& state() { return state_; }

 private:
    core::Result<void> prepare();
    /// Writes settings and recorded inputs.
    core::Result<void> keep();
    core::Result<void> keepSettings();
    core::Result<void> drawAll();
    core::Result<void> finish();
    /// --render-scale, the file's, or what the device can do.
    [[nodiscard]] float firstRenderScale() const;
    /// Seconds from this frame to the next, of the scene's time.
    [[nodiscard]] double sceneStep() const;
    [[nodiscard]] bool isLast(uint64_t frame) const;
    /// What happens next: from the window, or from the log. None while minimised.
    std::optional<Moment> nextMoment();
    void noteWindowedSize(graph::Extent size);

    void takeKeys(const Moment& moment);
    void drawPanels(const Moment& moment);
    /// \return whether the mouse's motion of this frame turns the camera
    bool useMouse(const Moment& moment);
    void moveCamera(const Moment& moment, bool turns);
    void meetWishes();

    core::Result<void> draw(const Moment& moment, uint64_t number);
    /// Brings the world to its time. While that stands still, edits of what moves stay; where they
    /// are undone, the user is told why.
    core::Result<void> follow();
    /// After a frame that failed: to the settings of one that did not, where they are others.
    core::Result<void> goBack(const core::Error& error);
    core::Result<void> present(const LoopFrame& frame, graph::Image shown);
    void saveScreenshot(const LoopFrame& frame, uint64_t number);
    [[nodiscard]] std::string title(const photon_gi::Renderer::Outcome& outcome) const;
    [[nodiscard]] bool wantsMeasurements() const;

    const ViewOptions& options_;
    window::Window& window_;
    FrameLoop& loop_;
    window::Presenter& presenter_;
    ShaderWatch& shaders_;

    /// A replay must not go by the clock.
    [[nodiscard]] bool repeatable() const { return recorder_ || !replayed_.empty(); }

    ViewState state_;
    LiveBudget budget_;  ///< holds the settings that are asked for
    std::optional<double> budgetMilliseconds_;
    photon_gi::Settings defaults_;
    LastDrawn lastDrawn_;
    double timestep_ = 0.0;      ///< seconds a frame
    double startSeconds_ = 0.0;  ///< of the scene's time
    ecs::Registry registry_;
    std::optional<overlay::Overlay> overlay_;
    std::optional<overlay::Panels> panels_;
    overlay::PlayControls play_;
    overlay::Handles handles_;
    ecs::Entity selected_;
    struct Edit {
        ecs::Entity entity;
        Movable before, after;
    };
    std::optional<Edit> edit_;               ///< what panels and handles did in this frame, if any
    std::string undoneMessage_;              ///< that one was undone, when it last was
    std::optional<double> followedSeconds_;  ///< of the scene's time, at the last follow()
    float metresAcross_ = 10.0f;             ///< the scene, while something was in it
    std::optional<graph::Extent> windowedSize_;    ///< pixels, when it was last not full screen
    std::optional<graph::Extent> fullScreenSize_;  ///< likewise, when it last was
    WalkCamera walk_;
    std::optional<LoopFrame> last_;  ///< the last frame, for the panels

    std::optional<InputRecorder> recorder_;
    std::vector<Moment> replayed_;
    size_t nextReplayed_ = 0;
    std::chrono::steady_clock::time_point lastPoll_;
    bool handlesHot_ = false;
    bool dragsCamera_ = false;
    double draggedPixels_ = 0.0;
    bool withOverlay_ = false;  ///< the screenshot that is asked for

    FrameRate rate_;
    Measured measured_;
    execute::ChromeTrace trace_;
    std::optional<flicker::Watch> watch_;
};

}  // namespace lampyris::sandbox::view
