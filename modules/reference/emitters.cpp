#include "reference/emitters.h"

#include <algorithm>
#include <cmath>

#include "reference/surface.h"
#include "reference/warps.h"

namespace lampyris::reference {
namespace {

// Points a side at which a textured triangle's glow is looked at. They only steer the choice: what
// they miss is still met by chance. [chosen]
constexpr int kSteps = 8;

float mean(const glm::vec3& rgb) {
    return (rgb.x + rgb.y + rgb.z) / 3.0f;
}

/// Mean radiance of a triangle's glowing side, W/(m² sr).
float meanRadiance(const PlacedMesh& placed, uint32_t primitive) {
    if (!placed.material->emissiveTexture.present()) return mean(placed.material->emissiveRadiance);
    float sum = 0.0f;
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j) {
            const glm::vec2 at = (glm::vec2(i, j) + 0.5f) / static_cast<float>(kSteps);
            const glm::vec2 uv = warpToTriangle(at);
            sum += mean(emittedRadiance(MeshPoint(placed, primitive, uv.x, uv.y), true));
        }
    return sum / static_cast<float>(kSteps * kSteps);
}

}  // namespace

Emitters::Emitters(const RayScene& scene) : scene_(&scene) {
    const auto instances = static_cast<uint32_t>(scene.snapshot().instances.size());
    densities_.resize(instances);
    std::vector<double> powers;  // of each triangle, up to a common factor
    for (uint32_t i = 0; i < instances; ++i) {
        const PlacedMesh* placed = scene.placed(i);
        if (placed != nullptr && mean(placed->material->emissiveRadiance) > 0.0f)
            add(i, *placed, powers);
    }
    double total = 0.0;
    for (const double power : powers) total += power;
    double upTo = 0.0;
    for (size_t k = 0; k < triangles_.size(); ++k) {
        upTo += powers[k];
        triangles_[k].cumulative = static_cast<float>(upTo / total);
    }
    if (!triangles_.empty()) triangles_.back().cumulative = 1.0f;
    for (auto& densities : densities_)
        for (float& density : densities) density = static_cast<float>(density / total);
}

void Emitters::add(uint32_t instance, const PlacedMesh& placed, std::vector<double>& powers) {
    const double sides = placed.material->doubleSided ? 2.0 : 1.0;
    std::vector<float>& densities = densities_[instance];
    densities.resize(placed.mesh->triangleCount(), 0.0f);
    for (uint32_t k = 0; k < densities.size(); ++k) {
        const glm::vec3 across = MeshPoint(placed, k, 0.0f, 0.0f).acrossWorld();
        const double radiance = sides * static_cast<double>(meanRadiance(placed, k));
        const double power = radiance * 0.5 * static_cast<double>(glm::length(across));
        if (!(power > 0.0) || !std::isfinite(power)) continue;
        densities[k] = static_cast<float>(radiance);
        triangles_.push_back({instance, k, 0.0f});
        powers.push_back(power);
    }
}

size_t Emitters::choose(float& xi) const {
    const auto chosen =
        std::upper_bound(triangles_.begin(), triangles_.end() - 1, xi,
                         [](float value, const Triangle& t) { return value < t.cumulative; });
    const float before = chosen == triangles_.begin() ? 0.0f : std::prev(chosen)->cumulative;
    // What is left of the number is spread evenly again.
    xi = std::clamp((xi - before) / std::max(chosen->cumulative - before, 1e-30f), 0.0f,
                    0x1.fffffep-1f);
    return static_cast<size_t>(chosen - triangles_.begin());
}

EmitterSample Emitters::sample(const glm::vec3& from, glm::vec3 xi) const {
    const Triangle& triangle = triangles_[choose(xi.x)];
    const glm::vec2 uv = warpToTriangle({xi.y, xi.z});
    const MeshPoint point(*scene_->placed(triangle.instance), triangle.primitive, uv.x, uv.y);
    EmitterSample sample;
    sample.position = point.positionWorld();
    sample.normal = glm::normalize(point.acrossWorld());
    const bool front = glm::dot(sample.normal, from - sample.position) > 0.0f;
    if (opaque(point)) sample.radiance = emittedRadiance(point, front);
    sample.density = density(triangle.instance, triangle.primitive);
    return sample;
}

float Emitters::density(uint32_t instance, uint32_t primitive) const {
    const std::vector<float>& densities = densities_[instance];
    return densities.empty() ? 0.0f : densities[primitive];
}

}  // namespace lampyris::reference
