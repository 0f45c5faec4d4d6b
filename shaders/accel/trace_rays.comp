#version 460
#extension GL_GOOGLE_include_directive : require
// Rays in a buffer → closest hits in a buffer. For tests and `bench rays`.
#include "lib/bvh_walk.glsl"
#include "shared/trace_rays.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = SLOT_TRACE_RAYS) uniform samplerBuffer rays;
layout(set = 0, binding = SLOT_TRACE_HITS, std430) writeonly buffer Hits { GpuHit hits[]; };
layout(constant_id = SPEC_TRACE_SURFACE) const uint withSurface = 0u;
layout(constant_id = SPEC_TRACE_OCCLUSION) const uint withOcclusion = 0u;
layout(push_constant) uniform Push { TraceRaysPush push; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= push.rayCount) return;
    vec4 from = texelFetch(rays, int(2u * index));
    vec4 towards = texelFetch(rays, int(2u * index + 1u));
    Hit hit;
    GpuHit result = GpuHit(vec4(towards.w, 0.0, 0.0, 0.0), vec4(0.0), vec4(0.0), SCENE_NONE, SCENE_NONE, 0u, 0u);
    if (traceClosest(from.xyz, towards.xyz, from.w, towards.w, hit)) {
        result.tBary = vec4(hit.t, hit.bary, 0.0);
        result.instance = hit.instance;
        result.primitive = hit.primitive;
        if (withSurface != 0u) {
            result.normal = vec4(hit.normalWorld, 0.0);
            result.albedo = vec4(hitAlbedo(hit), 0.0);
        }
    }
    if (withOcclusion != 0u) result.occluded = traceAny(from.xyz, towards.xyz, from.w, towards.w) ? 1u : 0u;
    hits[index] = result;
}
