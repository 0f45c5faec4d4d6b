/// \file What the surface is like at a point: the G-buffer's rules, for the reference.
#pragma once

#include "reference/placed_mesh.h"

namespace lampyris::reference {

/// A point that reflects light, seen from one side.
struct Surface {
    glm::vec3 position{0.0f};   ///< metres, world
    glm::vec3 geometric{0.0f};  ///< unit, towards the side that the ray came from
    glm::vec3 shading{0.0f};    ///< unit: interpolated and normal-mapped, turned along
    glm::vec3 albedo{0.0f};     ///< base colour · (1 − metallic)
    glm::vec3 f0{0.0f};         ///< of GGX; 0 is Lambertian
    float roughness = 1.0f;
    glm::vec3 emission{0.0f};  ///< of this side, W/(m² sr)

    [[nodiscard]] bool glossy() const { return f0 != glm::vec3(0.0f); }
};

/// As the camera and glossy paths see it.
[[nodiscard]] Surface surfaceAt(const MeshPoint& point, const glm::vec3& rayDirection);
/// As diffuse bounces see it: Lambertian, about the geometric normal.
[[nodiscard]] Surface mattSurfaceAt(const MeshPoint& point, const glm::vec3& rayDirection);

/// Emitted radiance of one side, W/(m² sr).
[[nodiscard]] glm::vec3 emittedRadiance(const MeshPoint& point, bool front);
/// False where alpha MASK cuts the surface out.
[[nodiscard]] bool opaque(const MeshPoint& point);

}  // namespace lampyris::reference
