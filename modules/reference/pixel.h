/// \file What stands under a pixel: a pinhole camera's ray through its centre.
#pragma once

#include <cstdint>
#include <optional>

#include "reference/direct_light.h"

namespace lampyris::reference {

/// Rays through pixel centres, y from the top.
class PixelRays {
 public:
    PixelRays(const scene::SnapshotCamera& camera, uint32_t width, uint32_t height);

    /// Parameters along the ray are metres along the camera's axis; starts at the near plane.
    [[nodiscard]] Ray through(uint32_t x, uint32_t y) const;
    /// Width of a pixel, at a metre along the axis.
    [[nodiscard]] float footprint() const { return 2.0f * tanHalf_ / height_; }

 private:
    glm::vec3 origin_;
    glm::mat3 toWorld_;
    float tanHalf_, width_, height_, near_;
};

/// The seen surface, if there is one, and the light's disc before it.
struct Pixel {
    std::optional<Surface> surface;
    uint32_t instance = 0;  ///< of the snapshot
    float depthMetres = 0.0f;
    glm::vec3 toEye{0.0f};          ///< unit
    std::optional<glm::vec3> disc;  ///< radiance of the nearest light's sphere
};

[[nodiscard]] Pixel lookThrough(const Stage& stage, const Ray& ray);

}  // namespace lampyris::reference
