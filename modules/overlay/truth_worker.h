/// \file The truth in the background: a reference of the view that refines while nothing moves, and
/// the measures of frames against it. No ImGui and no device.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "core/display.h"
#include "core/image.h"
#include "evaluation/comparison.h"
#include "execute/raw_image.h"
#include "reference/reference.h"
#include "scene/snapshot.h"

namespace lampyris::overlay {

/// What a frame was drawn from.
struct TruthView {
    const scene::SceneSnapshot& snapshot;  ///< for the call alone
    scene::SnapshotCamera camera;
    uint32_t width = 0, height = 0;  ///< pixels
    uint32_t maxBounces = reference::kAllBounces;
};

/// What views differ by: another snapshot of an unchanged world is the same view.
struct TruthKey {
    explicit TruthKey(const TruthView& view);
    bool operator==(const TruthKey&) const = default;
    [[nodiscard]] bool sameScene(const TruthKey& other) const;

    uint64_t geometryVersion, lightVersion, materialVersion;
    glm::mat4 cameraToWorld;
    float verticalFovRadians;
    uint32_t width, height, maxBounces;
};

/// A frame to be measured, as the device gave it.
struct TruthFrame {
    execute::RawImage radiance;  ///< linear
    execute::RawImage before;    ///< of the frame before it; empty: flicker is not known
    core::DisplayTransform display;
};

/// A frame's figures.
struct TruthFigures {
    double mse = 0.0, mssim = 0.0, flip = 0.0, relMse = 0.0;
    std::optional<double> change;  ///< mean |Y − Y before|, luma of 255
};

struct TruthState {
    uint32_t samples = 0;               ///< a pixel, in the reference so far
    double relativeError = 0.0;         ///< of the reference itself, as reference::Rendered has it
    double seconds = 0.0;               ///< spent on rendering it
    std::vector<TruthFigures> figures;  ///< of this view and display, the oldest first
    uint64_t pictures = 0;              ///< grows whenever one of the following two changes
    /// Null: none yet. difference: |…| of display values, four times.
    std::shared_ptr<const core::DisplayImage> reference, difference;
    std::string error;         ///< of the render, which then stands still
    std::string measureError;  ///< of the last frame
};

/// One thread of its own, which ends with it. It renders with one thread, beside the frames. No
/// call waits for that thread's work.
class TruthWorker {
 public:
    /// Calls of follow() with the same view, behind the first, until its reference is begun.
    /// [chosen] A camera or scene that moves has none built for it.
    static constexpr uint32_t kStandingFrames = 2;

    TruthWorker();
    ~TruthWorker();
    TruthWorker(const TruthWorker&) = delete;
    TruthWorker& operator=(const TruthWorker&) = delete;

    /// Once a frame. Gives whether the view is that of the last call; else all is begun anew.
    bool follow(const TruthView& view);
    /// Pauses until the next follow(). What was rendered stays, for the same view.
    void rest();
    /// Whether there is a reference, and no frame waits to be measured.
    [[nodiscard]] bool wantsFrame() const;
    void measure(TruthFrame frame);
    /// Drops figures and pictures, which the display transform has a part in.
    void forgetFigures();
    [[nodiscard]] TruthState state() const;

 private:
    struct Task {
        TruthKey key;
        scene::SceneSnapshot snapshot;
        scene::SnapshotCamera camera;
    };
    void dropFigures();
    void run();
    [[nodiscard]] bool refine(std::unique_lock<std::mutex>& lock);
    /// Where the scene is another one than it was built from.
    core::Result<void> build(const Task& task);
    void measureNow(std::unique_lock<std::mutex>& lock);

    // Of the thread that calls.
    std::optional<TruthKey> key_;
    uint32_t stood_ = 0;  ///< calls of follow() with that view, behind the first

    mutable std::mutex mutex_;  ///< held for no longer than a look at these
    std::condition_variable wake_;
    bool ends_ = false;
    bool rests_ = false;
    std::shared_ptr<const Task> task_;  ///< none before a view stands
    uint64_t views_ = 0;                ///< how often the view changed
    uint64_t series_ = 0;               ///< how often figures were begun anew
    std::optional<TruthFrame> frame_;
    TruthState state_;

    // Of the thread within.
    std::optional<reference::BuiltScene> scene_;
    std::optional<TruthKey> builtFrom_;
    core::Image sum_;     ///< of radiance, times samples
    uint64_t sumOf_ = 0;  ///< of views_
    std::thread thread_;
};

}  // namespace lampyris::overlay
