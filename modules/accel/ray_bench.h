/// \file How fast the shader walks the BVH, beside Embree on the same rays and cores.
#pragma once

#include <cstdint>

#include "core/result.h"
#include "execute/executor.h"
#include "scene/snapshot.h"

namespace lampyris::accel {

struct RayBenchSettings {
    uint32_t paths = 65536;
    uint32_t bounces = 4;  ///< diffuse bounces after the first hit; each is a batch of rays
    uint32_t repeats = 5;  ///< of which the medians are taken
    uint32_t seed = 1;
};

struct RayRates {
    uint64_t triangles = 0;
    uint64_t rays = 0;       ///< all bounces together
    uint64_t different = 0;  ///< hits further apart than rounding explains
    double gpuMraysPerSecond = 0.0;
    double embreeMraysPerSecond = 0.0;  ///< rtcIntersect1 on as many threads as cores
    [[nodiscard]] double ratio() const { return gpuMraysPerSecond / embreeMraysPerSecond; }
};

/// Sends paths in all directions from the middle of the scene, bounces them diffusely, and times
/// closest hits of bounces 1 to `bounces`: device timestamps for the shader, wall time for Embree,
/// turn by turn.
core::Result<RayRates> measureRays(execute::Executor& executor,
                                   const scene::SceneSnapshot& snapshot,
                                   const RayBenchSettings& settings = {});

}  // namespace lampyris::accel
