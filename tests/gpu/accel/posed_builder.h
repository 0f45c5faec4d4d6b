/// \file Scenes of instances that morph.
#pragma once

#include <memory>
#include <random>

#include "gpu/accel/trace_fixture.h"

namespace lampyris::test {

/// A soup with two morph targets of its own making.
inline assets::Mesh morphingSoup(uint32_t count, uint32_t seed) {
    assets::Mesh mesh = triangleSoup(count, 0.3f, seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    for (int target = 0; target < 2; ++target) {
        assets::MorphTarget morph;
        for (size_t i = 0; i < mesh.positions.size(); ++i)
            morph.positions.emplace_back(uniform(random), uniform(random), uniform(random));
        morph.normals.resize(mesh.positions.size(), glm::vec3(0.0f));
        mesh.morphTargets.push_back(std::move(morph));
    }
    mesh.morphWeights = {0.0f, 0.0f};
    return mesh;
}

struct PosedBuilder : SnapshotBuilder {
    void pose(uint32_t index, float first, float second) {
        auto& instance = snapshot.instances[index];
        instance.pose = std::make_shared<scene::Pose>(
            scene::Pose{.morphWeights = {first, second}, .jointMatrices = {}});
        instance.poseVersion = instance.version = ++lastVersion;
        snapshot.geometryVersion = lastVersion;
    }
    /// The same scene without poses: meshes that stand as posed.
    [[nodiscard]] scene::SceneSnapshot baked() const {
        scene::SceneSnapshot result = snapshot;
        for (auto& instance : result.instances) {
            if (instance.pose == nullptr) continue;
            auto mesh = std::make_shared<assets::Mesh>(*snapshot.meshes[instance.mesh].value);
            mesh->positions = scene::posedVertices(*mesh, *instance.pose).positions;
            instance.mesh = static_cast<uint32_t>(result.meshes.size());
            instance.pose = nullptr;
            result.meshes.push_back({mesh, 0});
        }
        return result;
    }
};

}  // namespace lampyris::test
