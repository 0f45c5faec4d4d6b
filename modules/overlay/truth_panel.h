/// \file Truth: how far frames are from a reference that refines in the background while the view
/// stands still; where the light's power went; what found no room.
#pragma once

#include <memory>
#include <optional>

#include "execute/copy_ring.h"
#include "overlay/frame_seen.h"
#include "overlay/image_look.h"
#include "overlay/truth_worker.h"

namespace lampyris::overlay {

/// Names of images that addNode() brings into the frame.
constexpr const char* kTruthReference = "truth: reference";
constexpr const char* kTruthDifference = "truth: difference";

class TruthPanel {
 public:
    static core::Result<TruthPanel> create(gpu::Device& device);

    /// After a frame was drawn whole, outside of its timed range. Where one is to be measured, it
    /// and the next are copied, which are looked at two frames later.
    /// \param radiance  the finished frame, as execute::Executor::outputImage() leaves it
    core::Result<void> follow(const TruthView& view, const core::DisplayTransform& display,
                              const gpu::Image& radiance, const graph::ImageDesc& desc);
    /// The picture among those above that is looked at, as an image of that name. None while
    /// nothing is followed.
    void addNode(graph::Frame& frame, const LookChoice& choice);
    void draw(const FrameSeen& seen, LookChoice& choice, bool* open);
    /// Whether follow() wants frames.
    [[nodiscard]] bool on() const { return on_; }
    /// In each frame in which follow() is not called: nothing is rendered or measured meanwhile.
    void rest();
    void switchOff() { on_ = false; }

 private:
    explicit TruthPanel(execute::CopyRing ring) : ring_(std::move(ring)) {}
    core::Result<void> copy(const gpu::Image& radiance, const graph::ImageDesc& desc);
    core::Result<void> dropCopies();
    void drawFigures(LookChoice& choice);

    execute::CopyRing ring_;
    std::unique_ptr<TruthWorker> worker_;  ///< none before it is first asked for
    bool on_ = false;
    bool rests_ = true;
    core::DisplayTransform display_;  ///< of the newest frame
    uint32_t copySteps_ = 0;          ///< of copy()
    execute::RawImage before_;        ///< the first of two frames
    std::vector<uint32_t> words_;     ///< of the picture that is looked at
    graph::Extent wordsExtent_{};
    uint64_t pictures_ = 0;  ///< that words_ are of
    std::string wordsName_;
};

}  // namespace lampyris::overlay
