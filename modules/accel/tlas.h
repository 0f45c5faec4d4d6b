/// \file The tree over a scene's instances.
#pragma once

#include <span>
#include <vector>

#include "accel/tree_builder.h"
#include "scene/snapshot.h"
#include "shared/bvh.h"

namespace lampyris::accel {

/// A BLAS once it has its place on the device.
struct BlasPlace {
    uint32_t rootLink = shared::BVH_NOTHING;  ///< absolute; BVH_NOTHING where it has no triangle
    uint32_t depth = 0;
    math::Bounds bounds;  ///< object space
    shared::GpuBvhGrid grid{};
};

/// Inner nodes, then the records of the instances.
struct Tlas {
    std::vector<Node> nodes;
    shared::GpuBvhRoot root{shared::BVH_NOTHING, shared::BVH_NOTHING, 0, 0, {}};
    uint32_t depth = 0;  ///< stack entries of a walk down to the deepest triangle
};

/// \param blas        of each instance of the snapshot
/// \param nodeOffset  where on the device the nodes will stand
core::Result<Tlas> buildTlas(TreeBuilder& builder, const scene::SceneSnapshot& snapshot,
                             std::span<const BlasPlace> blas, uint32_t nodeOffset);

/// The nodes that buildTlas makes at most for so many instances.
[[nodiscard]] inline uint32_t tlasCapacity(size_t instances) {
    return (1 + shared::BVH_RECORD_NODES) * static_cast<uint32_t>(instances) + 1;
}

}  // namespace lampyris::accel
