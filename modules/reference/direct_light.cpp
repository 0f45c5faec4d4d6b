#include "reference/direct_light.h"

#include <cmath>

namespace lampyris::reference {
namespace {

/// One light by its solid angle.
Received towardsLight(const Stage& stage, const Reflector& reflector,
                      const SphereLights::Choice& choice, glm::vec2 xi, uint64_t& rays) {
    const glm::vec3& origin = reflector.origin();
    const LightSample sample = stage.lights->sample(choice.light, origin, xi);
    const float cosine = reflector.diffuseCosine(sample.direction);
    glm::vec3 specular = reflector.specular(sample.direction);
    if (cosine <= 0.0f && specular == glm::vec3(0.0f)) return {};
    if (sample.radianceOverDensity == glm::vec3(0.0f)) return {};
    ++rays;
    if (stage.scene->blocked({origin, sample.direction, 0.0f, sample.distance})) return {};
    if (reflector.gloss())
        specular *= powerHeuristic(sample.density * choice.chance,
                                   reflector.gloss()->density(sample.direction));
    const glm::vec3 arriving = sample.radianceOverDensity * (1.0f / choice.chance);
    return {arriving * cosine, arriving * specular};
}

/// All lights that a direction of GGX meets: they do not hide each other.
glm::vec3 alongGloss(const Stage& stage, const Reflector& reflector, float total, glm::vec2 xi,
                     uint64_t& rays) {
    const SphereLights& lights = *stage.lights;
    const glm::vec3& origin = reflector.origin();
    const glm::vec3 direction = reflector.gloss()->sample(xi);
    const float density = reflector.gloss()->density(direction);
    const glm::vec3 specular = reflector.specular(direction);
    glm::vec3 sum(0.0f);
    if (!(density > 0.0f) || specular == glm::vec3(0.0f)) return sum;
    for (uint32_t i = 0; i < lights.count(); ++i) {
        const float chance = lights.importance(i, origin, reflector.geometricNormal()) / total;
        if (chance <= 0.0f) continue;
        const auto distance = lights.meet(i, origin, direction);
        if (!distance) continue;
        ++rays;
        if (stage.scene->blocked({origin, direction, 0.0f, *distance})) continue;
        const float weight = powerHeuristic(density, lights.density(i, origin) * chance);
        sum += specular * lights.radiance(i, direction) * (weight / density);
    }
    return sum;
}

}  // namespace

Received sphereLight(const Stage& stage, const Reflector& reflector, const glm::vec4& xi,
                     const OwenSobol& numbers, uint32_t vertex, uint64_t& rays) {
    const SphereLights::Choice choice =
        stage.lights->choose(reflector.origin(), reflector.geometricNormal(), xi.z);
    if (!(choice.chance > 0.0f)) return {};
    Received received = towardsLight(stage, reflector, choice, {xi.x, xi.y}, rays);
    if (reflector.gloss())
        received.specular +=
            alongGloss(stage, reflector, choice.total,
                       glm::vec2(numbers.group(groupOf(vertex, Use::Gloss))), rays);
    return received;
}

Received emitterLight(const Stage& stage, const Reflector& reflector, const OwenSobol& numbers,
                      uint32_t vertex, uint64_t& rays) {
    if (stage.emitters->empty()) return {};
    const glm::vec3& origin = reflector.origin();
    const EmitterSample sample =
        stage.emitters->sample(origin, glm::vec3(numbers.group(groupOf(vertex, Use::Emitter))));
    if (sample.radiance == glm::vec3(0.0f)) return {};
    const glm::vec3 to = sample.position - origin;
    const float d2 = glm::dot(to, to);
    if (!(d2 > 0.0f)) return {};
    const glm::vec3 direction = to / std::sqrt(d2);
    const float cosine = reflector.diffuseCosine(direction);
    const glm::vec3 specular = reflector.specular(direction);
    const float cosEmitter = std::abs(glm::dot(direction, sample.normal));
    if ((cosine <= 0.0f && specular == glm::vec3(0.0f)) || cosEmitter <= 0.0f) return {};
    // Up to just before the glowing surface.
    const float side = glm::dot(direction, sample.normal) > 0.0f ? -1.0f : 1.0f;
    const glm::vec3 end =
        sample.position + side * stage.scene->clearance() * sample.normal - origin;
    ++rays;
    if (stage.scene->blocked({origin, end, 0.0f, 1.0f})) return {};
    const float density = sample.density * d2 / cosEmitter;
    const glm::vec3 arriving =
        sample.radiance * (powerHeuristic(density, reflector.density(direction)) / density);
    return {arriving * cosine, arriving * specular};
}

}  // namespace lampyris::reference
