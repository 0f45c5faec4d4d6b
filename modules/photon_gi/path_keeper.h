/// \file Which paths a frame traces again and which go on from the frame before (`--retrace auto`).
#pragma once

#include <functional>

#include "photon_gi/settings.h"
#include "photons/photon_trace.h"
#include "scene/changes.h"

namespace lampyris::photon_gi {

/// What a frame's paths are.
struct PathPlan {
    photons::PathSplit split;
    photons::PathChoice choice;
    uint32_t turn = 0;  ///< photons::TraceSettings::turn of paths that are drawn anew
    bool kept = false;  ///< they go through the path store
};

/// While something moves, paths keep their number and their emitters: those that a change touches
/// are traced again, and with --reseed an eighth of the others. While nothing moves all are drawn
/// anew with --reseed, until the mean over frames is full, and none without it.
class PathKeeper {
 public:
    /// \param device must outlive this.
    explicit PathKeeper(residency::Device& device) : store_(device) {}

    struct Now {
        const std::vector<photons::Emitter>& emitters;
        const std::vector<scene::SnapshotLight>& lights;
        const scene::SceneChanges& changes;  ///< since the last plan
        uint64_t frameNumber;
    };
    /// \param newSplit draws the paths up anew
    [[nodiscard]] core::Result<PathPlan> plan(const Settings& settings, const Now& now,
                                              const std::function<photons::PathSplit()>& newSplit);
    /// The next plan's paths are all traced anew.
    void forget() { valid_ = false; }
    [[nodiscard]] photons::PathStoreHandles import(graph::Frame& frame) {
        return store_.import(frame);
    }
    [[nodiscard]] uint64_t deviceBytes() const { return store_.bytes(); }

 private:
    /// Whether the last plan's paths can go on; marks the ranges whose light changed.
    [[nodiscard]] bool goesOn(const Settings& settings, const Now& now,
                              photons::PathChoice& choice);

    [[nodiscard]] uint32_t turnOf(const Settings& settings, const Now& now);

    photons::PathStore store_;
    photons::PathSplit split_;  ///< of the last plan
    Settings settings_;
    std::vector<scene::SnapshotLight> lights_;
    bool valid_ = false;
    uint32_t age_ = 0;      ///< frames since the paths were drawn up
    uint32_t drawnIn_ = 0;  ///< the turn of the frame in which they were
};

}  // namespace lampyris::photon_gi
