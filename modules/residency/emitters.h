/// \file Emissive instances as sources of photons: power an instance, cumulative power over its
/// triangles.
#pragma once

#include <vector>

#include "scene/snapshot.h"
#include "shared/scene.h"

namespace lampyris::residency {

/// A triangle in world space, its front side towards cross(e1, e2); the texels of shared/scene.h.
struct EmitterTriangle {
    glm::vec3 v0{0.0f};
    uint32_t primitive = 0;
    glm::vec3 e1{0.0f};
    float cumulative = 0.0f;  ///< share of the emitter's power up to and with this triangle
    glm::vec3 e2{0.0f};
    float areaSquareMetres = 0.0f;
    glm::vec3 radiance{0.0f};      ///< mean over the triangle, W/(m²·sr)
    float cumulativeOfAll = 0.0f;  ///< share of all emitters' power up to and with this triangle
};
static_assert(sizeof(EmitterTriangle) == shared::EMITTER_TEXELS * sizeof(glm::vec4));

struct EmitterTable {
    std::vector<shared::GpuEmitter> emitters;  ///< in the order of the instances
    std::vector<EmitterTriangle> triangles;    ///< by primitive, those without power left out
};

/// Whether an instance glows, with or without an area to do so.
[[nodiscard]] bool emits(const scene::SceneSnapshot& snapshot,
                         const scene::SnapshotInstance& instance);

/// Power is π · radiance · area [E1], twice that where the material is double-sided.
[[nodiscard]] EmitterTable buildEmitters(const scene::SceneSnapshot& snapshot);

/// Grows or changes when buildEmitters would give something else.
[[nodiscard]] std::vector<uint64_t> emitterSignature(const scene::SceneSnapshot& snapshot);

}  // namespace lampyris::residency
