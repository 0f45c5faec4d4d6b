/// \file The truth in the background: a reference of the view that refines while nothing moves, and
/// the measures of frames against it. No ImGui and no device.
#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "core/display.h"
#include "core/image.h"
#include "evaluation/comparison.h"
#include "reference/reference.h"
#include "scene/snapshot.h"

namespace lampyris::overlay {

/// What a frame was drawn from. The reference is begun anew where it differs.
struct TruthView {
    scene::SceneSnapshot snapshot;
    scene::SnapshotCamera camera;
    uint32_t width = 0, height = 0;  ///< pixels
    uint32_t maxBounces = reference::kAllBounces;

    /// By versions: another snapshot of an unchanged world is the same view.
    [[nodiscard]] bool sameAs(const TruthView& other) const;
};

/// A frame to be measured.
struct TruthFrame {
    core::Image radiance;  ///< linear
    core::Image before;    ///< of the frame before it; empty: flicker is not known
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
    double seconds = 0.0;               ///< spent on it
    std::vector<TruthFigures> figures;  ///< of this view, the oldest first
    uint64_t pictures = 0;              ///< grows with each pair of the following two
    core::DisplayImage reference, difference;  ///< difference: |…| of display values, four times
    std::string error;
};

/// One thread of its own, which ends with it. It renders with one thread, beside the frames.
class TruthWorker {
 public:
    TruthWorker();
    ~TruthWorker();
    TruthWorker(const TruthWorker&) = delete;
    TruthWorker& operator=(const TruthWorker&) = delete;

    void follow(const TruthView& view);
    /// Rests until the next follow().
    void rest();
    /// Whether there is a reference, and no frame waits to be measured.
    [[nodiscard]] bool wantsFrame() const;
    void measure(TruthFrame frame);
    [[nodiscard]] TruthState state() const;
    /// state() without its pictures and their copying.
    [[nodiscard]] TruthState figures() const;

 private:
    void run();
    [[nodiscard]] bool refine(std::unique_lock<std::mutex>& lock);
    void measureNow(std::unique_lock<std::mutex>& lock);

    mutable std::mutex mutex_;
    std::condition_variable wake_;
    bool ends_ = false;
    std::optional<TruthView> view_;
    uint64_t views_ = 0;  ///< how often the view changed
    std::optional<TruthFrame> frame_;
    core::Image sum_;  ///< of radiance, times samples
    TruthState state_;
    std::thread thread_;
};

}  // namespace lampyris::overlay
