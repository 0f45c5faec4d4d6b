/// \file SceneSnapshots by hand, with versions as scene::extract keeps them.
#pragma once

#include <memory>
#include <random>
#include <utility>

#include "scene/snapshot.h"

namespace lampyris::test {

/// A snapshot that tests change step by step.
struct SnapshotBuilder {
    scene::SceneSnapshot snapshot;
    uint64_t lastVersion = 0;

    uint32_t addMesh(assets::Mesh mesh) {
        snapshot.meshes.push_back({});
        replaceMesh(static_cast<uint32_t>(snapshot.meshes.size()) - 1, std::move(mesh));
        return static_cast<uint32_t>(snapshot.meshes.size()) - 1;
    }
    void replaceMesh(uint32_t index, assets::Mesh mesh) {
        mesh.normals.resize(mesh.positions.size(), glm::vec3(0.0f, 0.0f, 1.0f));
        assets::updateBounds(mesh);
        snapshot.meshes[index] = {std::make_shared<assets::Mesh>(std::move(mesh)), ++lastVersion};
        snapshot.geometryVersion = lastVersion;
    }
    uint32_t addMaterial(assets::Material material) {
        snapshot.materials.push_back({});
        replaceMaterial(static_cast<uint32_t>(snapshot.materials.size()) - 1, std::move(material));
        return static_cast<uint32_t>(snapshot.materials.size()) - 1;
    }
    void replaceMaterial(uint32_t index, assets::Material material) {
        snapshot.materials[index] = {std::make_shared<assets::Material>(std::move(material)),
                                     ++lastVersion};
        snapshot.materialVersion = lastVersion;
    }
    int32_t addImage(assets::TextureImage image) {
        snapshot.images.push_back(
            {std::make_shared<assets::TextureImage>(std::move(image)), ++lastVersion});
        snapshot.materialVersion = lastVersion;
        return static_cast<int32_t>(snapshot.images.size()) - 1;
    }
    uint32_t addInstance(uint32_t mesh, uint32_t material,
                         const glm::mat4& matrix = glm::mat4(1.0f)) {
        const auto index = static_cast<uint32_t>(snapshot.instances.size());
        snapshot.instances.push_back(
            {.entity = ecs::Entity{index}, .mesh = mesh, .material = material});
        moveInstance(index, matrix);
        return index;
    }
    void moveInstance(uint32_t index, const glm::mat4& matrix) {
        snapshot.instances[index].objectToWorld = matrix;
        snapshot.instances[index].version = ++lastVersion;
        snapshot.geometryVersion = lastVersion;
        updateBounds();
    }
    void addLight(const scene::SnapshotLight& light) {
        snapshot.lights.push_back(light);
        snapshot.lights.back().version = ++lastVersion;
        snapshot.lightVersion = lastVersion;
    }
    void updateBounds() {
        snapshot.boundsWorld = {};
        for (auto& instance : snapshot.instances) {
            const auto& mesh = *snapshot.meshes[instance.mesh].value;
            instance.boundsWorld = math::transformed(mesh.bounds, instance.objectToWorld);
            snapshot.boundsWorld.grow(instance.boundsWorld);
        }
    }
};

/// Triangles of about `size` with corners anywhere in the cube from −1 to 1.
inline assets::Mesh triangleSoup(uint32_t count, float size, uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    const auto point = [&] { return glm::vec3(uniform(random), uniform(random), uniform(random)); };
    assets::Mesh mesh;
    for (uint32_t i = 0; i < count; ++i) {
        const glm::vec3 at = point();
        for (int corner = 0; corner < 3; ++corner) {
            mesh.indices.push_back(static_cast<uint32_t>(mesh.positions.size()));
            mesh.positions.push_back(at + size * point());
        }
    }
    return mesh;
}

/// The unit square in the plane z = 0, from (0, 0) to (1, 1), facing +z, texture coordinates as x
/// and y.
inline assets::Mesh unitSquare() {
    assets::Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.texcoords0 = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

/// A matt grey material.
inline assets::Material mattMaterial() {
    assets::Material material;
    material.baseColour = glm::vec4(0.5f, 0.5f, 0.5f, 1.0f);
    material.metallic = 0.0f;
    return material;
}

/// Turned, scaled unevenly (mirrored where `mirror`) and moved; the same for the same seed.
inline glm::mat4 anyTransform(uint32_t seed, bool mirror = false) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    const glm::vec3 axis = glm::normalize(glm::vec3(uniform(random), uniform(random), 1.1f));
    glm::mat4 matrix = glm::translate(
        glm::mat4(1.0f), 2.0f * glm::vec3(uniform(random), uniform(random), uniform(random)));
    matrix = glm::rotate(matrix, 3.0f * uniform(random), axis);
    const glm::vec3 scale(1.0f + 0.5f * uniform(random), 1.0f + 0.5f * uniform(random),
                          1.0f + 0.5f * uniform(random));
    return glm::scale(matrix, mirror ? glm::vec3(-scale.x, scale.y, scale.z) : scale);
}

}  // namespace lampyris::test
