/// \file How many paths each emitter gets, and what each path carries.
#pragma once

#include <cstdint>
#include <vector>

#include "math/glm.h"
#include "scene/snapshot.h"
#include "shared/photon.h"
#include "shared/scene.h"

namespace lampyris::photons {

/// Something that paths leave from.
struct Emitter {
    uint32_t kind = shared::EMIT_SPHERE;
    uint32_t index = 0;            ///< of the light, or of the GpuEmitter
    glm::vec3 sampledWatts{0.0f};  ///< what all its paths carry before a spot's falloff
    glm::vec3 powerWatts{0.0f};    ///< what it emits
};

/// The snapshot's lights and the emissive instances, those without power left out.
[[nodiscard]] std::vector<Emitter> listEmitters(const std::vector<scene::SnapshotLight>& lights,
                                                const std::vector<shared::GpuEmitter>& emissive);

struct PathSplit {
    std::vector<shared::PathRange> ranges;  ///< by firstPath; their pathCounts sum to `paths`
    uint32_t paths = 0;  ///< at least one an emitter, so it may exceed what was asked for
    bool anySurface =
        false;  ///< some paths start on an emissive surface: their first hit is stored too
    float powerScale = 1.0f;  ///< watts; the unit in which photons store power
};

/// Splits in proportion to power (largest remainders, at least one each). A photon's power is
/// divided by the paths emitted, here alone: each of an emitter's paths carries its power over its
/// own number of paths, so that emitted power sums to ΣΦ exactly, whatever the split.
[[nodiscard]] PathSplit splitPaths(const std::vector<Emitter>& emitters, uint32_t paths);

}  // namespace lampyris::photons
