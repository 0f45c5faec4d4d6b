/// \file The device, the scene and the renderer of one run, and its frames one after the other.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "ecs/world.h"
#include "execute/executor.h"
#include "gpu/device.h"
#include "options.h"
#include "photon_gi/renderer.h"
#include "scene/live_snapshot.h"

namespace lampyris::sandbox {

/// What found no room.
struct Dropped {
    uint64_t photons = 0, pairs = 0, cells = 0;
    void add(const shared::FrameCounters& counters);
};

/// A frame that was drawn whole.
struct LoopFrame {
    graph::Frame declared;
    photon_gi::Renderer::Outcome outcome;
    uint32_t rebuilds = 0;  ///< of bottom-level BVHs, for this frame
    double rebuildMilliseconds = 0.0;
    uint32_t refits = 0;  ///< of bottom-level BVHs, for this frame
    double refitMilliseconds = 0.0;
    double sahRatioMax = 1.0;         ///< as known after this frame
    double updateMilliseconds = 0.0;  ///< of follow(), wall time
    uint32_t repeats = 0;             ///< tries before it that were not whole
    Dropped dropped;                  ///< in those
};

/// What sets a window's frames apart from a file's.
struct Liveness {
    bool presentable = false;  ///< the device can show images
    bool repeatable = true;    ///< equal runs give equal frames, though one may wait for a BVH
};

class FrameLoop {
 public:
    using AddNodes = std::function<void(graph::Frame&, const photon_gi::DrawnFrame&)>;

    /// Errors name the device, scene or camera that is missing.
    static core::Result<std::unique_ptr<FrameLoop>> open(const Options& options,
                                                         const Liveness& live = {});

    /// Draws one frame at its time (--time and --timestep), and again where a buffer was too small,
    /// until it is whole. An image is read back where `readBack` is true: the one that
    /// --output-node names.
    core::Result<LoopFrame> draw(uint64_t frameNumber, bool readBack = false);
    /// One try of draw(): `outcome.report.valid` tells whether it is whole.
    /// \param readBack  a published image to be read back; empty: none
    /// \param addNodes  may add to the frame that was drawn
    core::Result<LoopFrame> tryDraw(uint64_t frameNumber, const std::string& readBack = {},
                                    const AddNodes& addNodes = {});
    /// Brings the world to `seconds`, and what changed in it to the renderer. draw() does so
    /// itself.
    core::Result<void> follow();
    /// The same at the time of the last one: what was edited since is not moved by the world's own
    /// systems.
    core::Result<void> followEdits();

    /// After an Error of tryDraw(): uploads the scene again, as what was on its way is lost, and
    /// gives back the room that frames had grown to.
    core::Result<void> beginAnew();

    /// What the next frames are drawn with.
    photon_gi::FrameRequest request;
    /// The world's time as of the next follow().
    double seconds = 0.0;

    [[nodiscard]] gpu::Device& device() { return *device_; }
    [[nodiscard]] execute::Executor& executor() { return *executor_; }
    [[nodiscard]] photon_gi::Renderer& renderer() { return *renderer_; }
    [[nodiscard]] ecs::World& world() { return world_; }
    /// As of the last follow().
    [[nodiscard]] const scene::SceneSnapshot& snapshot() const { return snapshot_.get(); }

 private:
    std::unique_ptr<gpu::Device> device_;
    std::optional<execute::Executor> executor_;
    std::optional<photon_gi::Renderer> renderer_;
    accel::AccelSettings accelSettings_;
    std::string outputNode_;
    ecs::World world_;
    scene::LiveSnapshot snapshot_;
    double startSeconds_ = 0.0;
    double timestep_ = 0.0;
};

}  // namespace lampyris::sandbox
