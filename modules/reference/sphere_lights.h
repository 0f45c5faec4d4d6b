/// \file Sphere lights seen from a point: which to sample, where it stands in the sky, what it
/// sends.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/snapshot.h"

namespace lampyris::reference {

/// A direction towards a light.
struct LightSample {
    glm::vec3 direction{0.0f};            ///< unit
    float distance = 0.0f;                ///< metres up to the glowing surface
    float density = 0.0f;                 ///< a steradian
    glm::vec3 radianceOverDensity{0.0f};  ///< W/m² at right angles to the direction
};

/// All lights that have power. Radiance Φ/(4π²r²) [R1], times the cone's falloff by the direction
/// in which the light travels. Seen from inside, a sphere glows all around.
class SphereLights {
 public:
    explicit SphereLights(const scene::SceneSnapshot& snapshot);

    [[nodiscard]] uint32_t count() const { return static_cast<uint32_t>(lights_.size()); }

    /// How much a light may matter at a point: 0 where none of it can be seen from the side that
    /// the normal points to. A light is chosen with its share of the sum over all.
    [[nodiscard]] float importance(uint32_t light, const glm::vec3& position,
                                   const glm::vec3& normal) const;
    struct Choice {
        uint32_t light = 0;
        float chance = 0.0f;  ///< 0 where there is none to choose
        float total = 0.0f;   ///< Σ importance
    };
    [[nodiscard]] Choice choose(const glm::vec3& position, const glm::vec3& normal, float xi) const;

    /// Uniform over the solid angle that the sphere fills.
    [[nodiscard]] LightSample sample(uint32_t light, const glm::vec3& position, glm::vec2 xi) const;
    /// Density of sample() in every direction that meets the light.
    [[nodiscard]] float density(uint32_t light, const glm::vec3& position) const;
    /// Distance to where a ray meets the glowing surface, if it does.
    [[nodiscard]] std::optional<float> meet(uint32_t light, const glm::vec3& origin,
                                            const glm::vec3& direction) const;
    [[nodiscard]] bool contains(uint32_t light, const glm::vec3& position) const;
    /// Sent against this direction, W/(m² sr).
    [[nodiscard]] glm::vec3 radiance(uint32_t light, const glm::vec3& direction) const;

 private:
    struct Light {
        glm::vec3 centre;
        float radius;
        glm::vec3 radiance;
        float power;  ///< mean of the channels, W
        glm::vec3 axis;
        float cosOuter, cosInner;
    };
    std::vector<Light> lights_;
};

}  // namespace lampyris::reference
