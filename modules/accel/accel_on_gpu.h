/// \file The scene's two-level BVH on the device: a tree a mesh at rest and one a posed instance
/// (BLAS), one tree over the instances (TLAS).
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "accel/accel_settings.h"
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
    uint32_t stackEntries = 64;  ///< at least what traversal needs; never falls
    graph::Buffer quality;       ///< to read back for AccelOnGpu::learn(), after the frame; invalid
                                 ///< where the device refits nothing
};

struct AccelCounts {
    uint64_t triangles = 0;  ///< in all BLASes; degenerate ones are left out of those at rest
    uint64_t dropped = 0;    ///< triangles that cannot be hit: degenerate or not finite
    uint32_t blas = 0;
    uint32_t refits = 0;       ///< BLASes that the last update() refitted, or has the device refit
    uint32_t rebuilds = 0;     ///< BLASes built by the last update(), or landed in it
    uint32_t deepest = 0;      ///< stack entries of the deepest path, TLAS and BLAS together
    double sahRatioMax = 1.0;  ///< of posed BLASes: expected cost of a ray to that after the build
    double refitMilliseconds = 0.0;  ///< CPU path, without posing; the device's stands in `refit…`
    double rebuildMilliseconds = 0.0;  ///< of `rebuilds`, on whichever thread
    double buildMilliseconds = 0.0;    ///< of the last update(), wall time
};

/// Owns the BVH. Update it after the SceneOnGpu it stands on, with the same snapshot.
class AccelOnGpu {
 public:
    /// Lives on the scene's device, which must outlive this.
    explicit AccelOnGpu(const residency::SceneOnGpu& scene, const AccelSettings& settings = {});
    ~AccelOnGpu();
    AccelOnGpu(AccelOnGpu&&) noexcept;
    AccelOnGpu& operator=(AccelOnGpu&&) noexcept;

    /// Builds a BLAS for every mesh and posed instance that is new, by version; refits those whose
    /// pose changed; and builds the TLAS anew when geometry changed. Once a frame. Degenerate
    /// triangles are left out or never hit. Errors name the limit that the scene exceeds.
    /// \param eyeWorld  what is seen large from there is rebuilt first
    core::Result<void> update(const scene::SceneSnapshot& snapshot,
                              const glm::vec3* eyeWorld = nullptr);

    /// Declares the BVH in a frame, with nodes `tlas_upload`, `upload bvh …` (new trees) and
    /// `refit…` where it changed.
    [[nodiscard]] AccelHandles import(graph::Frame& frame, const residency::SceneHandles& scene);
    /// What AccelHandles::quality of the last import held.
    void learn(std::span<const std::byte> quality);

    [[nodiscard]] const AccelCounts& counts() const;
    [[nodiscard]] uint64_t deviceBytes() const;

 private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// Same as accel.import(…); reads as a step of the frame's storyboard.
[[nodiscard]] inline AccelHandles importAccel(graph::Frame& frame, AccelOnGpu& accel,
                                              const residency::SceneHandles& scene) {
    return accel.import(frame, scene);
}

/// Binds what lib/bvh_walk.glsl reads at slots 16 to 25, and sets its specialization constants.
void bindTraversal(graph::ComputeNode& node, const AccelHandles& accel,
                   const residency::SceneHandles& scene);

}  // namespace lampyris::accel
