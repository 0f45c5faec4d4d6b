#include "scene/pose.h"

#include <algorithm>
#include <cmath>

namespace lampyris::scene {
namespace {

void morph(const assets::Mesh& mesh, const Pose& pose, PosedVertices& posed) {
    const size_t targets = std::min(mesh.morphTargets.size(), pose.morphWeights.size());
    for (size_t t = 0; t < targets; ++t) {
        const float weight = pose.morphWeights[t];
        if (weight == 0.0f) continue;
        const assets::MorphTarget& target = mesh.morphTargets[t];
        for (size_t i = 0; i < target.positions.size(); ++i)
            posed.positions[i] += weight * target.positions[i];
        for (size_t i = 0; i < target.normals.size(); ++i)
            posed.normals[i] += weight * target.normals[i];
    }
}

glm::mat4 blended(const Pose& pose, const glm::uvec4& joints, const glm::vec4& weights) {
    glm::mat4 sum(0.0f);
    for (int i = 0; i < 4; ++i)
        if (weights[i] != 0.0f) sum += weights[i] * pose.jointMatrices[joints[i]];
    return sum;
}

/// Normals go by the cofactors: the inverse transpose without a division, whole for flat matrices.
glm::mat3 cofactors(const glm::mat3& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

void skin(const assets::Mesh& mesh, const Pose& pose, PosedVertices& posed) {
    if (pose.jointMatrices.empty() || mesh.joints.empty()) return;
    for (size_t i = 0; i < posed.positions.size(); ++i) {
        const glm::mat4 matrix = blended(pose, mesh.joints[i], mesh.weights[i]);
        posed.positions[i] = glm::vec3(matrix * glm::vec4(posed.positions[i], 1.0f));
        posed.normals[i] = cofactors(glm::mat3(matrix)) * posed.normals[i];
        if (!posed.tangents.empty())
            posed.tangents[i] =
                glm::vec4(glm::mat3(matrix) * glm::vec3(posed.tangents[i]), posed.tangents[i].w);
    }
}

/// Unit, or as it was at rest where nothing is left of it.
glm::vec3 unitOr(const glm::vec3& v, const glm::vec3& rest) {
    const float largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0.0f) || !std::isfinite(largest)) return rest;
    return glm::normalize(v / largest);
}

}  // namespace

PosedVertices posedVertices(const assets::Mesh& mesh, const Pose& pose) {
    PosedVertices posed{mesh.positions, mesh.normals, mesh.tangents};
    morph(mesh, pose, posed);
    skin(mesh, pose, posed);
    for (size_t i = 0; i < posed.normals.size(); ++i)
        posed.normals[i] = unitOr(posed.normals[i], mesh.normals[i]);
    for (size_t i = 0; i < posed.tangents.size(); ++i)
        posed.tangents[i] = glm::vec4(
            unitOr(glm::vec3(posed.tangents[i]), glm::vec3(mesh.tangents[i])), posed.tangents[i].w);
    return posed;
}

}  // namespace lampyris::scene
