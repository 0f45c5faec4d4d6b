/// \file Light that arrives at a surface straight from a source: one sample of it.
#pragma once

#include <cstdint>

#include "reference/emitters.h"
#include "reference/owen_sobol.h"
#include "reference/reflector.h"
#include "reference/sphere_lights.h"

namespace lampyris::reference {

/// What a path meets. `rays` counts those that were traced.
struct Stage {
    const RayScene* scene;
    const SphereLights* lights;
    const Emitters* emitters;
};

struct Received {
    glm::vec3 irradiance{0.0f};  ///< W/m², without albedo
    glm::vec3 specular{0.0f};    ///< W/(m² sr), reflected to the eye
};

/// Sphere lights: one of them by its solid angle, and where the surface is glossy those that a
/// direction of GGX meets, joined by multiple importance sampling. `xi` is the vertex's group for
/// Use::Light.
Received sphereLight(const Stage& stage, const Reflector& reflector, const glm::vec4& xi,
                     const OwenSobol& numbers, uint32_t vertex, uint64_t& rays);

/// Emissive triangles: one point of them. The rest of the estimate is the path that goes on and
/// meets one: its weight is powerHeuristic(density of the path, density of this).
Received emitterLight(const Stage& stage, const Reflector& reflector, const OwenSobol& numbers,
                      uint32_t vertex, uint64_t& rays);

/// Groups of random numbers, a set for each surface of a path: the seen one is vertex 0.
enum class Use : uint32_t { Light, Gloss, Emitter, Continue, Count };
[[nodiscard]] constexpr uint32_t groupOf(uint32_t vertex, Use use) {
    return vertex * static_cast<uint32_t>(Use::Count) + static_cast<uint32_t>(use);
}

}  // namespace lampyris::reference
