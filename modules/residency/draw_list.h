/// \file What raster nodes draw, and what of it moved since the update before.
#pragma once

#include <unordered_map>
#include <vector>

#include "residency/mesh_streams.h"
#include "residency/posed_instances.h"
#include "residency/scene_handles.h"

namespace lampyris::residency {

class DrawList {
 public:
    /// Lists the snapshot's instances; what moved is told by the places of the last list.
    void follow(const scene::SceneSnapshot& snapshot, const MeshStreams& meshes,
                const PosedInstances& posed);
    /// The same instances in the same places: nothing moved.
    void settle(const scene::SceneSnapshot& snapshot);
    [[nodiscard]] const std::vector<DrawItem>& items() const { return items_; }

 private:
    void compare(DrawItem& item, const scene::SnapshotInstance& instance,
                 const PosedInstances& posed) const;

    std::vector<DrawItem> items_;
    std::unordered_map<uint64_t, glm::mat4> places_;  ///< objectToWorld by entity
    bool anyMoved_ = false;
};

}  // namespace lampyris::residency
