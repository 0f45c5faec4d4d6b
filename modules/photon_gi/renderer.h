/// \file What a program holds: the scene on the device, the room that frames need, and what each
/// frame reports.
#pragma once

#include <string>

#include "core/image.h"
#include "execute/executor.h"
#include "graph/compile.h"
#include "photon_gi/frame.h"
#include "photon_gi/path_keeper.h"
#include "photons/energy_ledger.h"
#include "photons/path_guide.h"
#include "residency/scene_on_gpu.h"
#include "scene/snapshot.h"

namespace lampyris::photon_gi {

struct FrameRequest {
    graph::Extent size{1280, 720};
    Settings settings{};
    uint64_t frameNumber = 0;
    scene::SnapshotCamera camera{};
    /// No published image but "final" will be asked for: frames may then be shown again whole.
    bool finalAlone = false;
};

/// Measured after the frame, outside its timed range.
struct FrameReport {
    uint32_t paths = 0;
    uint32_t retraced = 0;  ///< of them, in this frame
    shared::FrameCounters counters{};
    photons::EnergyLedger energy;
    glm::vec3 cutOffWatts{0.0f};
    bool valid = true;  ///< false: a store or list was too small; the next frame has more room
};

/// Errors: a published image of that name does not exist, a limit or memory of the device is
/// exceeded.
class Renderer {
 public:
    /// \param accel  a live program sets `rebuild.deterministic` to false: no frame then waits for
    /// a BVH that is being rebuilt
    explicit Renderer(execute::Executor& executor, const accel::AccelSettings& accel = {});

    /// Follows the snapshot: uploads what changed, builds what is new.
    core::Result<void> update(const scene::SceneSnapshot& snapshot);

    /// Declares one frame. The caller may add nodes (a present, an overlay) before run().
    /// Errors: memory of the device.
    [[nodiscard]] core::Result<DrawnFrame> declare(graph::Frame& frame,
                                                   const FrameRequest& request);

    struct Outcome {
        execute::FrameStatistics statistics;
        graph::CompiledGraph graph;
        FrameReport report;
        core::Image image;  ///< what `outputNode` named; empty where it was empty
        /// The picture on the device, RGBA16F, for Executor::outputImage. It is in the layout
        /// TRANSFER_SRC_OPTIMAL after draw(); after run() of a frame declared with `finalAlone` it
        /// may be one that is kept, in SHADER_READ_ONLY_OPTIMAL.
        graph::Image radiance;
    };
    /// Compiles and runs a declared frame and reads its report back; grows the room where it was
    /// too small.
    core::Result<Outcome> run(graph::Frame& frame, const DrawnFrame& drawn,
                              const std::string& outputNode, graph::CompileOptions options = {});

    /// The next frame begins anew: what earlier ones left was made by other shaders.
    void forget();
    /// update(), declare() and run() for a program that adds no nodes of its own. A picture that is
    /// kept is copied, so that all rest alike.
    core::Result<Outcome> draw(const scene::SceneSnapshot& snapshot, const FrameRequest& request,
                               const std::string& outputNode = {});

    [[nodiscard]] const accel::AccelOnGpu& accel() const { return accel_; }
    [[nodiscard]] const residency::SceneOnGpu& scene() const { return scene_; }
    /// How the last declared frame's paths are split over the emitters.
    [[nodiscard]] const photons::PathSplit& paths() const { return plan_.split; }
    [[nodiscard]] uint64_t deviceBytes() const {
        return scene_.deviceBytes() + accel_.deviceBytes() + keeper_.deviceBytes();
    }
    [[nodiscard]] Capacities& capacities() { return room_; }

 private:
    core::Result<void> makeRoom(const FrameRequest& request);
    /// What the mean over frames may go on from.
    [[nodiscard]] Past recall(const shared::View& view, const Settings& settings);
    /// Whether the next frame would only repeat the last.
    [[nodiscard]] bool settled(const shared::View& view, const FrameRequest& request) const;
    /// Whether neither scene nor view changed since the last frame.
    [[nodiscard]] bool seenAsDrawn(const shared::View& view) const;
    /// Gives the next frame the room that this one lacked. True where something was dropped or cut.
    /// An error where more room cannot be had.
    core::Result<bool> grow(const shared::FrameCounters& counters);
    /// \param share  of its largest room that the last batch needed
    void fitBatches(double share);

    execute::Executor* executor_;
    residency::SceneOnGpu scene_;
    accel::AccelOnGpu accel_;
    std::vector<photons::Emitter> emitters_;
    photons::PathGuide guide_;
    PathKeeper keeper_;
    PathPlan plan_;
    /// What the last frame's mean was made from.
    struct Drawn {
        bool whole = false;      ///< there is one, and its light was all there
        bool keptFinal = false;  ///< its picture can be shown again
        Settings settings;
        graph::Extent size{};
        glm::mat4 worldToClip{1.0f};
    };
    Drawn drawn_;
    uint32_t stillFrames_ = 0;       ///< in which nothing changed, nor did the view
    FrameReport lastReport_;         ///< of a frame that was whole
    scene::SceneSnapshot snapshot_;  ///< of the last update()
    scene::SceneChanges changes_;    ///< since the last declared frame
    uint32_t framesSinceChange_ = 0;
    glm::vec3 eyeWorld_{0.0f};             ///< of the last frame's camera
    graph::Buffer treeQuality_;            ///< of the declared frame
    uint32_t largestBatch_ = 0xffffffffu;  ///< paths; less while a batch's pairs do not fit
    uint32_t lastBatch_ = 0;               ///< the largest of the last frame
    uint32_t mostPairs_ = 0;               ///< that one batch may have at this size
    bool shadows_ = false;                 ///< in the declared frame
    Capacities room_;
};

}  // namespace lampyris::photon_gi
