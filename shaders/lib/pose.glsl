// What the morph and skin nodes share: their jobs, rest vertices, and how posed ones are put away.
#ifndef LAMPYRIS_LIB_POSE
#define LAMPYRIS_LIB_POSE
#include "shared/pose.h"
#include "shared/scene.h"

layout(push_constant) uniform Push { PoseParams params; };
layout(set = 0, binding = SLOT_POSE_JOBS, std430) readonly buffer Jobs { PoseJob jobs[]; };
layout(set = 0, binding = SLOT_REST_VERTICES) uniform usamplerBuffer restVertices;
layout(set = 0, binding = SLOT_POSES) uniform samplerBuffer poses;
layout(set = 0, binding = SLOT_POSED_POSITIONS, rgba32f) uniform imageBuffer posedPositions;
layout(set = 0, binding = SLOT_POSED_NORMALS, r32f) uniform imageBuffer posedNormals;
layout(set = 0, binding = SLOT_POSED_TANGENTS, rgba32f) writeonly uniform imageBuffer posedTangents;
layout(set = 0, binding = SLOT_POSED_POSITIONS_BEFORE, rgba32f) writeonly uniform imageBuffer positionsBefore;

uint poseThread() {
    return (gl_WorkGroupID.y * POSE_GROUPS_IN_ROW + gl_WorkGroupID.x) * POSE_THREADS + gl_LocalInvocationID.x;
}

PoseJob jobOf(uint thread) {
    uint low = 0u, high = params.jobCount - 1u;
    while (low < high) {
        uint middle = (low + high + 1u) / 2u;
        if (jobs[middle].firstThread <= thread) low = middle;
        else high = middle - 1u;
    }
    return jobs[low];
}

struct RestVertex {
    vec3 position, normal;
    vec4 weights, tangent;
    uvec4 joints;
};

RestVertex restVertex(PoseJob job, uint vertex) {
    int first = int((job.firstRest + vertex) * REST_TEXELS);
    uvec4 a = texelFetch(restVertices, first), b = texelFetch(restVertices, first + 1);
    return RestVertex(uintBitsToFloat(a.xyz), uintBitsToFloat(b.xyz),
                      uintBitsToFloat(texelFetch(restVertices, first + 2)),
                      uintBitsToFloat(texelFetch(restVertices, first + 3)),
                      uvec4(a.w & 0xffffu, a.w >> 16, b.w & 0xffffu, b.w >> 16));
}

vec3 positionAt(uint vertex) { return imageLoad(posedPositions, int(vertex)).xyz; }

vec3 normalAt(uint vertex) {
    int at = int(vertex * 3u);
    return vec3(imageLoad(posedNormals, at).x, imageLoad(posedNormals, at + 1).x, imageLoad(posedNormals, at + 2).x);
}

void putPosition(uint vertex, vec3 p) { imageStore(posedPositions, int(vertex), vec4(p, 0.0)); }

void putNormal(uint vertex, vec3 n) {
    int at = int(vertex * 3u);
    imageStore(posedNormals, at, vec4(n.x));
    imageStore(posedNormals, at + 1, vec4(n.y));
    imageStore(posedNormals, at + 2, vec4(n.z));
}

// Keeps where the vertex stood in the frame before; once a frame, before anything is put there.
void keepBefore(PoseJob job, uint vertex) {
    imageStore(positionsBefore, int(job.firstBefore + vertex), vec4(positionAt(job.firstVertex + vertex), 0.0));
}

// Unit, or as it was at rest where nothing is left of it: the twin of unitOr in engine/scene/pose.cpp.
vec3 unitOr(vec3 v, vec3 rest) {
    float largest = max(abs(v.x), max(abs(v.y), abs(v.z)));
    if (!(largest > 0.0) || isinf(largest) || isnan(largest)) return rest;
    return normalize(v / largest);
}

void putTangent(PoseJob job, uint vertex, vec3 posed, vec4 rest) {
    if (job.firstTangent == SCENE_NONE) return;
    imageStore(posedTangents, int(job.firstTangent + vertex), vec4(unitOr(posed, rest.xyz), rest.w));
}

#endif
