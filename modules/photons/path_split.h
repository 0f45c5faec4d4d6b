/// \file How many paths each emitter gets, and what each path carries.
#pragma once

#include <cstdint>
#include <span>
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

/// A part of an emitter's way out, which gets paths of its own.
struct EmitterPart {
    Emitter emitter;                           ///< with the part's share of the power
    glm::vec4 square{0.0f, 0.0f, 1.0f, 1.0f};  ///< of the unit square: its corner, its sides
};

/// Splits in proportion to power times worth (largest remainders, at least one each). A photon's
/// power is divided by the paths emitted, here alone: each of a part's paths carries its power over
/// its own number of paths, so that emitted power sums to ΣΦ exactly, whatever the split.
/// \param worth of a part's watt; empty: all the same
[[nodiscard]] PathSplit splitPaths(const std::vector<EmitterPart>& parts, uint32_t paths,
                                   std::span<const double> worth = {});
/// Each emitter as one part, by power alone.
[[nodiscard]] PathSplit splitPaths(const std::vector<Emitter>& emitters, uint32_t paths);

/// Gives the paths of a split the power that its emitters have now, their numbers as they are.
/// False where the emitters are others, or their powers so much larger that photons could not hold
/// them.
[[nodiscard]] bool repower(PathSplit& split, const std::vector<Emitter>& emitters);

}  // namespace lampyris::photons
