/// \file Meshes with joints and morph targets, and poses for them.
#pragma once

#include "support/snapshot_builder.h"

namespace lampyris::test {

/// A soup whose vertices hang on up to four of `joints` joints and move with `targets` targets; 0
/// leaves either out.
inline assets::Mesh deformableSoup(uint32_t triangles, uint32_t joints, uint32_t targets,
                                   uint32_t seed, bool tangents = true) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    const auto vector = [&] {
        return glm::vec3(uniform(random), uniform(random), uniform(random));
    };
    assets::Mesh mesh = triangleSoup(triangles, 0.3f, seed);
    const size_t count = mesh.positions.size();
    for (size_t i = 0; i < count; ++i) {
        mesh.normals.push_back(glm::normalize(vector() + glm::vec3(1e-3f)));
        if (tangents)
            mesh.tangents.emplace_back(glm::normalize(vector() + glm::vec3(1e-3f)),
                                       uniform(random) < 0.0f ? -1.0f : 1.0f);
        if (joints == 0) continue;
        glm::vec4 weights = glm::abs(glm::vec4(vector(), uniform(random)));
        if (i % 3 == 0) weights.z = weights.w = 0.0f;
        mesh.weights.push_back(weights / (weights.x + weights.y + weights.z + weights.w));
        mesh.joints.emplace_back(random() % joints, random() % joints, random() % joints,
                                 random() % joints);
    }
    for (uint32_t t = 0; t < targets; ++t) {
        assets::MorphTarget target;
        for (size_t i = 0; i < count; ++i) target.positions.push_back(0.2f * vector());
        for (size_t i = 0; i < count && t % 2 == 0; ++i) target.normals.push_back(vector());
        mesh.morphTargets.push_back(target);
        mesh.morphWeights.push_back(0.0f);
    }
    return mesh;
}

inline std::shared_ptr<scene::Pose> anyPose(uint32_t joints, uint32_t targets, uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    auto pose = std::make_shared<scene::Pose>();
    for (uint32_t i = 0; i < joints; ++i)
        pose->jointMatrices.push_back(anyTransform(seed + 100 * i, i % 5 == 4));
    for (uint32_t i = 0; i < targets; ++i)
        pose->morphWeights.push_back(i % 3 == 1 ? 0.0f : uniform(random));
    return pose;
}

/// Gives an instance a pose, or takes it away.
inline void setPose(SnapshotBuilder& builder, uint32_t index,
                    std::shared_ptr<const scene::Pose> pose) {
    auto& instance = builder.snapshot.instances[index];
    instance.pose = std::move(pose);
    instance.version = instance.poseVersion = ++builder.lastVersion;
    builder.snapshot.geometryVersion = builder.lastVersion;
}

}  // namespace lampyris::test
