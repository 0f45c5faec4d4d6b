/// \file Embree's own traversal of a scene: what the GPU's is compared with.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/result.h"
#include "scene/snapshot.h"
#include "shared/trace_rays.h"

namespace lampyris::accel {

/// All triangles of a snapshot in world space, in one Embree scene. Alpha masks are not looked at.
class EmbreeRays {
 public:
    static core::Result<EmbreeRays> create(const scene::SceneSnapshot& snapshot);
    ~EmbreeRays();
    EmbreeRays(EmbreeRays&&) noexcept;
    EmbreeRays& operator=(EmbreeRays&&) noexcept;

    /// Closest hits by rtcIntersect1, on as many threads as there are cores. Normals are geometric,
    /// world space; `occluded` and `albedo` stay 0.
    void trace(std::span<const shared::GpuRay> rays, std::span<shared::GpuHit> hits) const;
    [[nodiscard]] uint64_t triangleCount() const;

 private:
    struct Parts;
    explicit EmbreeRays(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace lampyris::accel
