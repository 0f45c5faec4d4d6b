// Rays and hits of accel/trace_rays.comp.
#ifndef LAMPYRIS_SHARED_TRACE_RAYS_H
#define LAMPYRIS_SHARED_TRACE_RAYS_H

#include "shared/glsl_compat.h"

LAMPYRIS_SHARED_BEGIN

LAMPYRIS_SLOT(SLOT_TRACE_RAYS, 0u);  // texels RGBA32Float, a GpuRay in two
LAMPYRIS_SLOT(SLOT_TRACE_HITS, 1u);

// Specialization constants: what is asked for beside the hit. What is not must cost nothing in a measurement.
LAMPYRIS_SLOT(SPEC_TRACE_SURFACE, 0u);
LAMPYRIS_SLOT(SPEC_TRACE_OCCLUSION, 1u);

struct GpuRay {
    vec4 originTMin;
    vec4 directionTMax;
};

struct GpuHit {
    vec4 tBary;     // t, barycentrics of the second and third corner
    vec4 normal;    // geometric, world; where asked for
    vec4 albedo;    // where asked for
    uint instance;  // SCENE_NONE for a miss
    uint primitive;
    uint occluded;  // what traceAny says; where asked for
    uint pad0;
};

struct TraceRaysPush {
    uint rayCount;
    uint pad0, pad1, pad2;
};

LAMPYRIS_SHARED_END

#endif
