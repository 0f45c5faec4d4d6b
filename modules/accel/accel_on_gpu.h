/// \file The scene's two-level BVH on the device: a tree a mesh (BLAS), one tree over the instances
/// (TLAS).
#pragma once

#include <cstdint>
#include <memory>

#include "core/result.h"
#include "graph/frame.h"
#include "residency/scene_on_gpu.h"
#include "shared/bvh.h"

namespace lampyris::accel {

/// The BVH in one graph::Frame.
struct AccelHandles {
    graph::Buffer nodes;      ///< RGBA32Float texels, BVH_NODE_TEXELS a node; TLAS and BLASes
    graph::Buffer triangles;  ///< RGBA32Float texels, BVH_TRIANGLE_TEXELS a triangle
    shared::GpuBvhRoot root;
    uint32_t stackEntries = 8;  ///< what traversal needs; a multiple of 8
};

struct AccelCounts {
    uint64_t triangles = 0;  ///< in all BLASes, degenerate ones left out
    uint32_t blas = 0;
    uint32_t rebuilds = 0;           ///< BLASes built by the last update()
    uint32_t deepest = 0;            ///< stack entries of the deepest path, TLAS and BLAS together
    double buildMilliseconds = 0.0;  ///< of the last update(), wall time
};

/// Owns the BVH. Update it after the SceneOnGpu it stands on, with the same snapshot.
class AccelOnGpu {
 public:
    /// Lives on the scene's device, which must outlive this.
    explicit AccelOnGpu(const residency::SceneOnGpu& scene);
    ~AccelOnGpu();
    AccelOnGpu(AccelOnGpu&&) noexcept;
    AccelOnGpu& operator=(AccelOnGpu&&) noexcept;

    /// Builds a BLAS for every mesh that is new, by version, and the TLAS anew when geometry
    /// changed. Triangles that are degenerate or not finite are left out. Errors name the limit
    /// that the scene exceeds.
    core::Result<void> update(const scene::SceneSnapshot& snapshot);

    /// Declares the BVH in a frame, with a node `tlas_upload` where it changed.
    [[nodiscard]] AccelHandles import(graph::Frame& frame);

    [[nodiscard]] const AccelCounts& counts() const;
    [[nodiscard]] uint64_t deviceBytes() const;

 private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// Same as accel.import(frame); reads as a step of the frame's storyboard.
[[nodiscard]] inline AccelHandles importAccel(graph::Frame& frame, AccelOnGpu& accel) {
    return accel.import(frame);
}

/// Binds what lib/bvh_walk.glsl reads at slots 16 to 25, and sets its specialization constants.
void bindTraversal(graph::ComputeNode& node, const AccelHandles& accel,
                   const residency::SceneHandles& scene);

}  // namespace lampyris::accel
