#include "reference/sphere_lights.h"

#include <algorithm>
#include <cmath>

#include "reference/warps.h"

namespace lampyris::reference {
namespace {

// Points have infinite radiance: a light is at least this large. [chosen: a speck of dust]
constexpr float kLeastRadius = 1e-5f;

/// 1 − cos of half the angle that a sphere of sin² fills, without cancellation.
float oneMinusCos(float sine2) {
    return sine2 / (1.0f + std::sqrt(std::max(0.0f, 1.0f - sine2)));
}

/// Falloff between the cones, as KHR_lights_punctual recommends it.
float falloff(float cosAngle, float cosInner, float cosOuter) {
    const float t =
        std::clamp((cosAngle - cosOuter) / std::max(cosInner - cosOuter, 1e-4f), 0.0f, 1.0f);
    return t * t;
}

}  // namespace

SphereLights::SphereLights(const scene::SceneSnapshot& snapshot) {
    for (const scene::SnapshotLight& light : snapshot.lights) {
        const float power = (light.powerWatts.x + light.powerWatts.y + light.powerWatts.z) / 3.0f;
        if (!(power > 0.0f)) continue;
        const float radius = std::max(light.radiusMetres, kLeastRadius);
        lights_.push_back({light.positionWorld, radius,
                           light.powerWatts / (4.0f * math::kPi * math::kPi * radius * radius),
                           power, light.directionWorld, light.cosOuterCone, light.cosInnerCone});
    }
}

float SphereLights::importance(uint32_t index, const glm::vec3& position,
                               const glm::vec3& normal) const {
    const Light& light = lights_[index];
    const glm::vec3 to = light.centre - position;
    const float d2 = glm::dot(to, to), r2 = light.radius * light.radius;
    if (d2 <= r2) return light.power / r2;
    if (glm::dot(normal, to) <= -light.radius) return 0.0f;
    if (light.cosOuter > -1.0f) {
        // The rays of the sphere that reach the point differ from the centre's by its half-angle.
        const float angle =
            std::acos(std::clamp(glm::dot(-to, light.axis) / std::sqrt(d2), -1.0f, 1.0f));
        const float least = angle - std::asin(light.radius / std::sqrt(d2));
        if (least > 0.0f && std::cos(least) <= light.cosOuter) return 0.0f;
    }
    return light.power / d2;
}

SphereLights::Choice SphereLights::choose(const glm::vec3& position, const glm::vec3& normal,
                                          float xi) const {
    Choice choice;
    for (uint32_t i = 0; i < count(); ++i) choice.total += importance(i, position, normal);
    if (!(choice.total > 0.0f)) return choice;
    if (count() == 1) return {0, 1.0f, choice.total};
    float left = xi * choice.total;
    for (uint32_t i = 0; i < count() && left >= 0.0f; ++i) {
        const float share = importance(i, position, normal);
        if (share <= 0.0f) continue;
        choice.light = i;  // the last of them where rounding leaves something
        choice.chance = share / choice.total;
        left -= share;
    }
    return choice;
}

LightSample SphereLights::sample(uint32_t index, const glm::vec3& position, glm::vec2 xi) const {
    const Light& light = lights_[index];
    const glm::vec3 to = light.centre - position;
    const float d2 = glm::dot(to, to), r2 = light.radius * light.radius;
    const bool inside = d2 <= r2;
    const float height = inside ? 2.0f : oneMinusCos(r2 / d2);
    const glm::vec3 local = warpToCone(xi, height);
    LightSample sample;
    sample.direction = inside ? local : Frame(to * (1.0f / std::sqrt(d2))).toWorld(local);
    const float solidAngle = 2.0f * math::kPi * height;
    sample.density = 1.0f / solidAngle;
    const float along = glm::dot(sample.direction, to);
    const glm::vec3 aside = to - along * sample.direction;
    const float half = std::sqrt(std::max(0.0f, r2 - glm::dot(aside, aside)));
    sample.distance = std::max(0.0f, inside ? along + half : along - half);
    sample.radianceOverDensity = radiance(index, sample.direction) * solidAngle;
    return sample;
}

float SphereLights::density(uint32_t index, const glm::vec3& position) const {
    const Light& light = lights_[index];
    const glm::vec3 to = light.centre - position;
    const float d2 = glm::dot(to, to), r2 = light.radius * light.radius;
    const float height = d2 <= r2 ? 2.0f : oneMinusCos(r2 / d2);
    return 1.0f / (2.0f * math::kPi * height);
}

std::optional<float> SphereLights::meet(uint32_t index, const glm::vec3& origin,
                                        const glm::vec3& direction) const {
    const Light& light = lights_[index];
    const glm::vec3 to = light.centre - origin;
    const float along = glm::dot(direction, to);
    const float d2 = glm::dot(to, to), r2 = light.radius * light.radius;
    // The ray's least distance from the centre, from a vector: not a difference of squares.
    const glm::vec3 aside = to - along * direction;
    const float half2 = r2 - glm::dot(aside, aside);
    if (half2 < 0.0f) return std::nullopt;
    const float half = std::sqrt(half2);
    if (d2 <= r2) return along + half;
    return along > 0.0f ? std::optional<float>(std::max(0.0f, along - half)) : std::nullopt;
}

bool SphereLights::contains(uint32_t index, const glm::vec3& position) const {
    const glm::vec3 to = lights_[index].centre - position;
    return glm::dot(to, to) <= lights_[index].radius * lights_[index].radius;
}

glm::vec3 SphereLights::radiance(uint32_t index, const glm::vec3& direction) const {
    const Light& light = lights_[index];
    if (light.cosOuter <= -1.0f) return light.radiance;
    return light.radiance *
           falloff(glm::dot(-direction, light.axis), light.cosInner, light.cosOuter);
}

}  // namespace lampyris::reference
