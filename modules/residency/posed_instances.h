/// \file Deformed instances: a range of vertices each, posed on the device when the pose changes.
#pragma once

#include <unordered_map>

#include "residency/mesh_streams.h"
#include "residency/pose_nodes.h"
#include "residency/rest_meshes.h"

namespace lampyris::residency {

class PosedInstances {
 public:
    explicit PosedInstances(Device& device);

    /// Gives each deformed instance of the snapshot its range of the streams, and takes back those
    /// of instances that are gone, rest again or have another mesh. Before MeshStreams::follow.
    void place(const scene::SceneSnapshot& snapshot, MeshStreams& streams);
    /// Loads rest vertices that are new, and stages the joints and weights of poses that changed
    /// for the next import(). After MeshStreams::follow. \return the bytes of both. Errors name the
    /// limit.
    core::Result<uint64_t> load(const scene::SceneSnapshot& snapshot, const MeshStreams& streams);
    /// Nothing changed since: no vertex moved.
    void settle();
    /// Declares `upload poses`, `morph` and `skin` where poses changed since the last import(), and
    /// fills in positionsBefore.
    void import(graph::Frame& frame, SceneHandles& handles);

    /// The mesh's range with the instance's own vertices, where it has some.
    [[nodiscard]] MeshRange rangeOf(const scene::SnapshotInstance& instance,
                                    const MeshRange& mesh) const;
    /// First vertex in positionsBefore where the last load() found another pose, or SCENE_NONE.
    [[nodiscard]] uint32_t firstBefore(const scene::SnapshotInstance& instance) const;
    [[nodiscard]] const std::vector<PosedInstance>& list() const { return list_; }
    [[nodiscard]] uint64_t bytes() const {
        return rest_.bytes() + poses_.bytes() + before_.bytes();
    }

 private:
    struct Entry {
        PosedRange range;
        uint64_t meshVersion = 0;
        uint64_t poseVersion = 0;
        uint32_t firstBefore = 0;
        bool placed = false;   ///< its vertices were written, or will be: there is a before
        bool moved = false;    ///< the last load() found another pose
        bool pending = false;  ///< not yet imported
        uint64_t seen = 0;     ///< the last place() that met it
    };

    void addJobs(const assets::Mesh& mesh, const scene::Pose& pose, const Entry& entry,
                 std::vector<glm::vec4>& texels);

    RestMeshes rest_;
    ResidentBuffer poses_;
    ResidentBuffer before_;
    std::unordered_map<uint64_t, Entry> entries_;  ///< by entity
    std::vector<PosedInstance> list_;
    PoseJobs morphs_;
    PoseJobs skins_;
    uint64_t round_ = 0;
};

}  // namespace lampyris::residency
