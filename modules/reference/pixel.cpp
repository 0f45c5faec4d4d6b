#include "reference/pixel.h"

#include <cmath>

namespace lampyris::reference {

PixelRays::PixelRays(const scene::SnapshotCamera& camera, uint32_t width, uint32_t height)
    : origin_(camera.cameraToWorld[3]),
      toWorld_(camera.cameraToWorld),
      tanHalf_(std::tan(0.5f * camera.verticalFovRadians)),
      width_(static_cast<float>(width)),
      height_(static_cast<float>(height)),
      near_(camera.nearMetres) {}

Ray PixelRays::through(uint32_t x, uint32_t y) const {
    const glm::vec2 centre(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
    const float halfPixel = tanHalf_ / height_;
    const glm::vec3 view(halfPixel * (2.0f * centre.x - width_),
                         halfPixel * (height_ - 2.0f * centre.y), -1.0f);
    return {origin_, toWorld_ * view, near_};
}

Pixel lookThrough(const Stage& stage, const Ray& ray) {
    Pixel pixel;
    const float length = glm::length(ray.direction);
    const glm::vec3 direction = ray.direction / length;
    pixel.toEye = -direction;
    float nearest = std::numeric_limits<float>::infinity();
    if (const auto hit = stage.scene->closest(ray)) {
        pixel.surface = surfaceAt(stage.scene->pointAt(*hit), direction);
        pixel.instance = hit->instance;
        pixel.depthMetres = hit->t;
        nearest = hit->t * length;
    }
    for (uint32_t i = 0; i < stage.lights->count(); ++i) {
        const auto distance = stage.lights->meet(i, ray.origin, direction);
        if (!distance || *distance >= nearest || stage.lights->contains(i, ray.origin)) continue;
        nearest = *distance;
        pixel.disc = stage.lights->radiance(i, direction);
    }
    return pixel;
}

}  // namespace lampyris::reference
