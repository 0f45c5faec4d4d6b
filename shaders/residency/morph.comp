// One thread a vertex of an instance whose pose changed: rest vertex plus weighted offsets [glTF 2.0, 3.7.2.2].
// What no joint moves afterwards is finished here; the rest is left to the skin node, normals not yet unit.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/pose.glsl"

layout(local_size_x = 64) in;  // POSE_THREADS
layout(set = 0, binding = SLOT_MORPH_DELTAS) uniform samplerBuffer morphDeltas;

void main() {
    uint thread = poseThread();
    if (thread >= params.threadCount) return;
    PoseJob job = jobOf(thread);
    uint vertex = thread - job.firstThread;
    RestVertex rest = restVertex(job, vertex);
    vec3 position = rest.position, normal = rest.normal;
    for (uint i = 0u; i < job.weightCount; ++i) {
        vec2 weight = texelFetch(poses, int(job.firstWeight + i)).xy;
        int delta = int((job.firstDelta + uint(weight.y) * job.vertexCount + vertex) * DELTA_TEXELS);
        position += weight.x * texelFetch(morphDeltas, delta).xyz;
        normal += weight.x * texelFetch(morphDeltas, delta + 1).xyz;
    }
    keepBefore(job, vertex);
    bool last = (job.flags & POSE_SKINNED) == 0u;
    putPosition(job.firstVertex + vertex, position);
    putNormal(job.firstVertex + vertex, last ? unitOr(normal, rest.normal) : normal);
    if (last) putTangent(job, vertex, rest.tangent.xyz, rest.tangent);
}
