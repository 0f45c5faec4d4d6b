/// \file Rays through the scene, by Embree.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include "core/result.h"
#include "reference/placed_mesh.h"

namespace lampyris::reference {

/// Points origin + t · direction with near < t < far.
struct Ray {
    glm::vec3 origin{0.0f};
    glm::vec3 direction{0.0f};  ///< need not be unit
    float near = 0.0f;
    float far = std::numeric_limits<float>::infinity();
};

struct RayHit {
    uint32_t instance = 0;   ///< of the snapshot
    uint32_t primitive = 0;  ///< triangle of its mesh
    float u = 0.0f, v = 0.0f;
    float t = 0.0f;  ///< in lengths of the ray's direction
};

/// The snapshot's triangles in world space. Both sides are hit; alpha MASK is cut out. Calls are
/// safe from many threads, and answers do not depend on how many there are.
class RayScene {
 public:
    /// Fails where Embree does, say for want of memory.
    static core::Result<RayScene> build(scene::SceneSnapshot snapshot);
    ~RayScene();
    RayScene(RayScene&&) noexcept;
    RayScene& operator=(RayScene&&) noexcept;

    [[nodiscard]] std::optional<RayHit> closest(const Ray& ray) const;
    [[nodiscard]] bool blocked(const Ray& ray) const;

    /// The point hit, kept off its triangle's edges by some clearances.
    [[nodiscard]] MeshPoint pointAt(const RayHit& hit) const;
    [[nodiscard]] const scene::SceneSnapshot& snapshot() const;
    /// Nothing where the instance has no triangles in the world.
    [[nodiscard]] const PlacedMesh* placed(uint32_t instance) const;
    /// How far from a surface a ray starts, so that rounding does not let it hit that surface:
    /// metres.
    [[nodiscard]] float clearance() const;

 private:
    struct Parts;
    explicit RayScene(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace lampyris::reference
