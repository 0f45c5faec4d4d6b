// One thread a vertex of an instance whose joints changed: linear blend skinning [glTF 2.0, 3.7.3.3], in place
// where the morph node wrote before.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/pose.glsl"

layout(local_size_x = 64) in;  // POSE_THREADS

// Rows of the blended matrix.
mat3x4 blendedRows(PoseJob job, uvec4 joints, vec4 weights) {
    mat3x4 rows = mat3x4(0.0);
    for (int i = 0; i < 4; ++i) {
        if (weights[i] == 0.0) continue;
        int first = int(job.firstJoint + min(joints[i], job.jointCount - 1u) * JOINT_TEXELS);
        rows += weights[i] * mat3x4(texelFetch(poses, first), texelFetch(poses, first + 1), texelFetch(poses, first + 2));
    }
    return rows;
}

void main() {
    uint thread = poseThread();
    if (thread >= params.threadCount) return;
    PoseJob job = jobOf(thread);
    uint vertex = thread - job.firstThread;
    RestVertex rest = restVertex(job, vertex);
    bool morphed = (job.flags & POSE_MORPHED) != 0u;
    if (!morphed) keepBefore(job, vertex);
    vec3 position = morphed ? positionAt(job.firstVertex + vertex) : rest.position;
    vec3 normal = morphed ? normalAt(job.firstVertex + vertex) : rest.normal;

    mat3x4 rows = blendedRows(job, rest.joints, rest.weights);
    putPosition(job.firstVertex + vertex, vec4(position, 1.0) * rows);
    // Rows of the cofactor matrix: the inverse transpose without a division, whole for flat matrices.
    vec3 r0 = rows[0].xyz, r1 = rows[1].xyz, r2 = rows[2].xyz;
    vec3 turned = vec3(dot(cross(r1, r2), normal), dot(cross(r2, r0), normal), dot(cross(r0, r1), normal));
    putNormal(job.firstVertex + vertex, unitOr(turned, rest.normal));
    putTangent(job, vertex, vec3(dot(r0, rest.tangent.xyz), dot(r1, rest.tangent.xyz), dot(r2, rest.tangent.xyz)), rest.tangent);
}
