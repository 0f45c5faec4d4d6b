/// \file Small meshes that can be bent.
#pragma once

#include <algorithm>
#include <random>

#include "scene/pose.h"

namespace lampyris::test {

inline float between(std::mt19937& random, float least, float most) {
    return std::uniform_real_distribution<float>(least, most)(random);
}

inline glm::vec3 anyPoint(std::mt19937& random, float reach) {
    return {between(random, -reach, reach), between(random, -reach, reach),
            between(random, -reach, reach)};
}

/// So many triangles anywhere in a cube of half that side, following any of the joints.
inline assets::Mesh bendableSoup(uint32_t triangles, uint32_t joints, uint32_t targets,
                                 uint32_t seed, float reach = 1.0f) {
    std::mt19937 random(seed);
    assets::Mesh mesh;
    for (uint32_t i = 0; i < 3 * triangles; ++i) {
        mesh.positions.push_back(anyPoint(random, reach));
        mesh.normals.push_back(glm::normalize(anyPoint(random, 1.0f) + glm::vec3(0, 2, 0)));
        mesh.indices.push_back(i);
        if (joints == 0) continue;
        mesh.joints.emplace_back(random() % joints, random() % joints, random() % joints, 0);
        const glm::vec4 weights(between(random, 0, 1), between(random, 0, 1), between(random, 0, 1),
                                0.0f);
        mesh.weights.push_back(weights / (weights.x + weights.y + weights.z));
    }
    for (uint32_t t = 0; t < targets; ++t) {
        assets::MorphTarget& target = mesh.morphTargets.emplace_back();
        for (size_t i = 0; i < mesh.positions.size(); ++i)
            target.positions.push_back(anyPoint(random, 0.5f * reach));
    }
    mesh.morphWeights.assign(targets, 0.0f);
    assets::updateBounds(mesh);
    return mesh;
}

inline glm::mat4 anyMatrix(std::mt19937& random, float reach) {
    const glm::quat turn = glm::angleAxis(between(random, 0, 6),
                                          glm::normalize(anyPoint(random, 1) + glm::vec3(0, 0, 2)));
    return glm::translate(glm::mat4(1.0f), anyPoint(random, reach)) * glm::mat4_cast(turn) *
           glm::scale(glm::mat4(1.0f), anyPoint(random, 2.0f));
}

inline scene::Pose anyPose(uint32_t joints, uint32_t targets, uint32_t seed, float reach = 3.0f) {
    std::mt19937 random(seed);
    scene::Pose pose;
    for (uint32_t t = 0; t < targets; ++t) pose.morphWeights.push_back(between(random, -2, 2));
    for (uint32_t j = 0; j < joints; ++j) pose.jointMatrices.push_back(anyMatrix(random, reach));
    return pose;
}

}  // namespace lampyris::test
