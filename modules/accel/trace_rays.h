/// \file Rays in a buffer → hits in a buffer: traversal on its own, for tests and measurements.
#pragma once

#include <cstdint>

#include "accel/accel_on_gpu.h"
#include "shared/trace_rays.h"

namespace lampyris::accel {

struct TraceRaysSettings {
    uint32_t rayCount = 0;
    bool withSurface = false;    ///< fill GpuHit's normal and albedo
    bool withOcclusion = false;  ///< ask traceAny too
};

/// \param rays  shared::GpuRay, bound as texels
/// \return      shared::GpuHit, as many as rays
[[nodiscard]] graph::Buffer addTraceRays(graph::Frame& frame, const AccelHandles& accel,
                                         const residency::SceneHandles& scene, graph::Buffer rays,
                                         const TraceRaysSettings& settings);

}  // namespace lampyris::accel
