/// \file A tree of its own for every posed instance: built at first sight, refitted whenever its
/// pose changes, rebuilt in the background where refits made it bad.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <stop_token>

#include "accel/accel_settings.h"
#include "accel/rebuild_worker.h"
#include "accel/refit_nodes.h"
#include "accel/tlas.h"
#include "accel/tree_store.h"
#include "residency/scene_handles.h"
#include "scene/snapshot.h"

namespace lampyris::accel {

/// Of the last follow().
struct PosedCounts {
    uint32_t trees = 0;
    uint32_t refits = 0;
    uint32_t builds = 0;           ///< first builds, and rebuilds that landed
    uint64_t dropped = 0;          ///< triangles that cannot be hit; on the device as of the last
                                   ///< readQuality()
    double costRatioMax = 1.0;     ///< as last known
    double refitMilliseconds = 0;  ///< on the CPU, without posing
    double posingMilliseconds = 0;
    double buildMilliseconds = 0;  ///< of those builds, on whichever thread
};

class PosedTrees {
 public:
    /// \param onCpu who refits
    PosedTrees(TreeStore& store, TreeBuilder& builder, bool onCpu, const RebuildPolicy& policy);

    /// Follows the snapshot's posed instances: forgets, lands, builds, refits and asks for
    /// rebuilds. \param posed  residency's, of the same snapshot \param eyeWorld  what is nearer to
    /// it is rebuilt first
    core::Result<void> follow(const scene::SceneSnapshot& snapshot,
                              std::span<const residency::PosedInstance> posed,
                              const glm::vec3* eyeWorld);
    /// Whether follow() has something to do although no instance changed.
    [[nodiscard]] bool busy() const { return inFlight_ > 0 || wanting_; }

    [[nodiscard]] const BlasPlace& place(ecs::Entity entity) const;
    /// What the device must refit in this frame; to be asked once a frame.
    [[nodiscard]] std::vector<RefitJob> takeJobs();
    /// What Refitted::quality held, of the jobs of the last takeJobs().
    void learn(std::span<const std::byte> quality);
    [[nodiscard]] const PosedCounts& counts() const { return counts_; }

 private:
    using Future = std::future<core::Result<PosedBlas>>;
    struct Posed {
        std::shared_ptr<const assets::Mesh> mesh;
        uint64_t meshVersion = 0;
        scene::PoseExtents extents;
        uint64_t poseVersion = 0;  ///< that the boxes are for
        TreeRange range;
        BlasPlace place;
        Tree tree;                      ///< absolute links; without nodes where the device refits
        std::vector<uint32_t> corners;  ///< of leafCorners(), likewise
        std::vector<uint32_t> levels;
        uint32_t nodes = 0;
        double builtCost = 0.0, cost = 0.0;
        uint32_t dropped = 0;
        bool refitOnDevice = false;
        uint32_t firstVertex = 0, firstIndex = 0;
        std::optional<Future> rebuild;
        std::stop_source forgotten;
        uint64_t askedAt = 0;
        /// A tree over nothing costs 0, any other at least 1: one that was built from a mesh
        /// without area is bad as soon as it has some.
        [[nodiscard]] double ratio() const {
            return std::max(cost, 1.0) / std::max(builtCost, 1.0);
        }
    };
    /// A job whose quality is to be learnt.
    struct Asked {
        uint32_t entity;
        uint32_t nodes;
    };
    /// A tree on its way to the device.
    struct Arrival {
        uint32_t entity;
        PosedBlas built;
        bool first;
    };
    using Instances = std::map<uint32_t, const scene::SnapshotInstance*>;

    void forget(const scene::SceneSnapshot& snapshot, const Instances& instances);
    core::Result<void> collectArrivals(const scene::SceneSnapshot& snapshot,
                                       const Instances& instances, std::vector<Arrival>& arrivals);
    [[nodiscard]] bool lands(const Posed& posed) const;
    /// Takes over all of the tree but its nodes, and gives it a range.
    void settle(Posed& posed, PosedBlas& built);
    core::Result<void> send(std::vector<Arrival>& arrivals);
    core::Result<void> refit(Posed& posed, const scene::SnapshotInstance& instance);
    core::Result<void> refitNow(Posed& posed, const scene::Pose& pose);
    void sumUp();
    void askForRebuilds(const Instances& instances, const glm::vec3* eyeWorld);

    TreeStore* store_;
    TreeBuilder* builder_;
    bool onCpu_;
    RebuildPolicy policy_;
    RebuildWorker worker_;
    std::map<uint32_t, Posed> trees_;  ///< by entity
    std::vector<Asked> asked_;         ///< by the last takeJobs()
    uint64_t frame_ = 0;
    uint32_t inFlight_ = 0;  ///< rebuilds
    bool wanting_ = false;   ///< a tree is bad and not yet being rebuilt
    PosedCounts counts_;
};

}  // namespace lampyris::accel
