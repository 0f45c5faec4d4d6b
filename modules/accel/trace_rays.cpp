#include "accel/trace_rays.h"

#include "accel/shaders.h"

namespace lampyris::accel {

graph::Buffer addTraceRays(graph::Frame& frame, const AccelHandles& accel,
                           const residency::SceneHandles& scene, graph::Buffer rays,
                           const TraceRaysSettings& settings) {
    auto node = frame.compute("trace_rays", shaders::traceRays);
    bindTraversal(node, accel, scene);
    node.texels(shared::SLOT_TRACE_RAYS, rays, graph::Format::RGBA32Float)
        .specialise(shared::SPEC_TRACE_SURFACE, settings.withSurface ? 1 : 0)
        .specialise(shared::SPEC_TRACE_OCCLUSION, settings.withOcclusion ? 1 : 0)
        .push(shared::TraceRaysPush{settings.rayCount, 0, 0, 0});
    const graph::Buffer hits = node.write(
        shared::SLOT_TRACE_HITS,
        frame.buffer("ray hits", {uint64_t{settings.rayCount} * sizeof(shared::GpuHit)}));
    node.dispatchOver({settings.rayCount, 1});
    return hits;
}

}  // namespace lampyris::accel
