#include "reference/path_tracer.h"

#include <algorithm>
#include <cmath>

namespace lampyris::reference {
namespace {

// Paths before this many bounces are never ended by chance; [measured: cornell, noise at equal
// time]
constexpr uint32_t kRouletteFrom = 3;
// A path always ends some day, even where nothing is absorbed. [chosen]
constexpr float kMostSurvival = 0.98f;

float largest(const glm::vec3& rgb) {
    return std::max({rgb.x, rgb.y, rgb.z});
}

glm::vec3 reflected(const Reflector& reflector, const Received& received) {
    return reflector.albedo() * (1.0f / math::kPi) * received.irradiance + received.specular;
}

}  // namespace

PathTracer::PathTracer(const Stage& stage, uint32_t maxBounces, Transport transport)
    : stage_(stage), maxBounces_(maxBounces), glossyPaths_(transport == Transport::Full) {}

PathTracer::Seen PathTracer::look(const Surface& surface, const glm::vec3& toEye) const {
    const float clearance = stage_.scene->clearance();
    return {Reflector(surface, toEye, surface.shading, true, clearance),
            Reflector(surface, toEye, surface.shading, glossyPaths_, clearance)};
}

LightSplit PathTracer::sample(const Seen& seen, const OwenSobol& numbers) {
    LightSplit split;
    const Received direct =
        sphereLight(stage_, seen.lit, numbers.group(groupOf(0, Use::Light)), numbers, 0, rays_);
    split.irradianceDirect = direct.irradiance;
    split.specularDirect = direct.specular;
    if (maxBounces_ == 0) return split;

    const Received glow = emitterLight(stage_, seen.scattering, numbers, 0, rays_);
    split.irradianceIndirect = glow.irradiance;
    split.specularIndirect = glow.specular;
    const glm::vec3 direction =
        seen.scattering.sample(glm::vec3(numbers.group(groupOf(0, Use::Continue))));
    const float density = seen.scattering.density(direction);
    if (!(density > 0.0f)) return split;
    const float cosine = seen.scattering.diffuseCosine(direction);
    const glm::vec3 specular = seen.scattering.specular(direction);
    if (cosine <= 0.0f && specular == glm::vec3(0.0f)) return split;
    const glm::vec3 radiance =
        arriving({seen.scattering.origin(), direction}, density, numbers) / density;
    split.irradianceIndirect += radiance * cosine;
    split.specularIndirect += radiance * specular;
    return split;
}

glm::vec3 PathTracer::arriving(Ray ray, float density, const OwenSobol& numbers) {
    glm::vec3 sum(0.0f), throughput(1.0f);
    for (uint32_t bounce = 1;; ++bounce) {
        // Drawn before the ray is traced, and the direction before the shadow rays: the processor
        // does both at once.
        const glm::vec4 xi = numbers.group(groupOf(bounce, Use::Continue));
        const glm::vec4 xiLight = numbers.group(groupOf(bounce, Use::Light));
        ++rays_;
        const auto hit = stage_.scene->closest(ray);
        if (!hit) return sum;
        const MeshPoint point = stage_.scene->pointAt(*hit);
        const Surface surface =
            glossyPaths_ ? surfaceAt(point, ray.direction) : mattSurfaceAt(point, ray.direction);
        if (surface.emission != glm::vec3(0.0f)) {
            const float cosine = std::abs(glm::dot(surface.geometric, ray.direction));
            const float other = stage_.emitters->density(hit->instance, hit->primitive) * hit->t *
                                hit->t / std::max(cosine, 1e-6f);
            sum += throughput * surface.emission * powerHeuristic(density, other);
        }
        if (bounce > maxBounces_) return sum;

        const Reflector reflector(surface, -ray.direction, surface.geometric, glossyPaths_,
                                  stage_.scene->clearance());
        const glm::vec3 direction = reflector.sample(glm::vec3(xi));
        density = reflector.density(direction);
        sum += throughput * reflected(reflector, sphereLight(stage_, reflector, xiLight, numbers,
                                                             bounce, rays_));
        sum += throughput *
               reflected(reflector, emitterLight(stage_, reflector, numbers, bounce, rays_));
        if (bounce == maxBounces_ && stage_.emitters->empty()) return sum;

        if (!(density > 0.0f)) return sum;
        throughput *= reflected(reflector, {glm::vec3(reflector.diffuseCosine(direction)),
                                            reflector.specular(direction)}) *
                      (1.0f / density);
        if (bounce >= kRouletteFrom) {
            const float survival = std::min(largest(throughput), kMostSurvival);
            if (xi.w >= survival) return sum;
            throughput /= survival;
        }
        if (throughput == glm::vec3(0.0f)) return sum;
        ray = {reflector.origin(), direction};
    }
}

}  // namespace lampyris::reference
