#include "reference/pixel.h"

#include <cmath>

#include "reference/warps.h"

namespace lampyris::reference {
namespace {

/// [chosen] Beside a ray, as a share of the distance: far less than a pixel, more than rounding.
constexpr float kBeside = 1e-5f;

bool meetsTheBack(const Stage& stage, const Ray& ray, const RayHit& hit) {
    return glm::dot(stage.scene->pointAt(hit).acrossWorld(), ray.direction) > 0.0f;
}

/// A ray through an edge meets either triangle, by rounding; at an outline one of them is seen from
/// behind, and all is dark inside a closed shape. What lies just beside the edge is what is seen.
std::optional<RayHit> seenAlong(const Stage& stage, const Ray& ray) {
    const auto hit = stage.scene->closest(ray);
    if (!hit || !meetsTheBack(stage, ray, *hit)) return hit;
    const float length = glm::length(ray.direction);
    const Frame around(ray.direction / length);
    for (const glm::vec3& way :
         {around.tangent, -around.tangent, around.bitangent, -around.bitangent}) {
        Ray beside = ray;
        beside.direction += kBeside * length * way;
        const auto other = stage.scene->closest(beside);
        if (other && !meetsTheBack(stage, beside, *other)) return other;
    }
    return hit;
}

}  // namespace

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
    if (const auto hit = seenAlong(stage, ray)) {
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
