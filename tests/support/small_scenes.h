/// \file Cameras, shapes and lights for scenes that a test builds by hand.
#pragma once

#include <cmath>
#include <memory>
#include <utility>

#include "scene/snapshot.h"

namespace lampyris::test {

inline scene::SnapshotCamera lookFrom(const glm::vec3& eye, const glm::vec3& target,
                                      float fovDegrees = 60.0f,
                                      const glm::vec3& up = {0.0f, 1.0f, 0.0f}) {
    scene::SnapshotCamera camera;
    camera.cameraToWorld = glm::inverse(glm::lookAt(eye, target, up));
    camera.verticalFovRadians = glm::radians(fovDegrees);
    return camera;
}

/// Adds a mesh with a Lambertian material at a transform.
inline void addInstance(scene::SceneSnapshot& snapshot, assets::Mesh mesh,
                        const assets::Material& material,
                        const glm::mat4& objectToWorld = glm::mat4(1.0f)) {
    const auto next = static_cast<uint32_t>(snapshot.instances.size());
    assets::updateBounds(mesh);
    snapshot.boundsWorld.grow(math::transformed(mesh.bounds, objectToWorld));
    snapshot.meshes.push_back({std::make_shared<assets::Mesh>(std::move(mesh)), next + 1});
    snapshot.materials.push_back({std::make_shared<assets::Material>(material), next + 1});
    snapshot.instances.push_back({ecs::Entity{next}, next, next, objectToWorld, next + 1});
    snapshot.geometryVersion = snapshot.materialVersion = next + 1;
}

inline assets::Material lambertian(const glm::vec3& albedo) {
    assets::Material material;
    material.baseColour = glm::vec4(albedo, 1.0f);
    material.metallic = 0.0f;
    material.specularFactor = 0.0f;
    return material;
}

inline void addLight(scene::SceneSnapshot& snapshot, const glm::vec3& position, float radius,
                     float watts) {
    scene::SnapshotLight light;
    light.entity = ecs::Entity{1000 + static_cast<uint32_t>(snapshot.lights.size())};
    light.positionWorld = position;
    light.radiusMetres = radius;
    light.powerWatts = glm::vec3(watts);
    light.version = snapshot.lights.size() + 1;
    snapshot.lights.push_back(light);
    snapshot.lightVersion = snapshot.lights.size();
}

/// A quad with corners in order, normal to the side from which they run counter-clockwise.
inline assets::Mesh quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                         const glm::vec3& d) {
    assets::Mesh mesh;
    mesh.positions = {a, b, c, d};
    mesh.normals.assign(4, glm::normalize(glm::cross(b - a, c - a)));
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

/// A sphere about the origin, normals outwards.
inline assets::Mesh uvSphere(float radius, uint32_t slices, uint32_t stacks) {
    assets::Mesh mesh;
    for (uint32_t i = 0; i <= stacks; ++i)
        for (uint32_t j = 0; j <= slices; ++j) {
            const float theta = math::kPi * static_cast<float>(i) / static_cast<float>(stacks);
            const float phi =
                2.0f * math::kPi * static_cast<float>(j % slices) / static_cast<float>(slices);
            const glm::vec3 n(std::sin(theta) * std::cos(phi), std::cos(theta),
                              std::sin(theta) * std::sin(phi));
            mesh.positions.push_back(radius * (i == 0 || i == stacks
                                                   ? glm::vec3(0.0f, i == 0 ? 1.0f : -1.0f, 0.0f)
                                                   : n));
            mesh.normals.push_back(n);
        }
    for (uint32_t i = 0; i < stacks; ++i)
        for (uint32_t j = 0; j < slices; ++j) {
            const uint32_t a = i * (slices + 1) + j;
            const uint32_t b = a + slices + 1;
            if (i > 0) mesh.indices.insert(mesh.indices.end(), {a, a + 1, b + 1});
            if (i + 1 < stacks) mesh.indices.insert(mesh.indices.end(), {a, b + 1, b});
        }
    return mesh;
}

/// Closed, 4 m wide and 3 m high, from x0 to x1.
inline void addRoom(scene::SceneSnapshot& snapshot, float x0, float x1) {
    const auto white = lambertian(glm::vec3(0.7f));
    const auto add = [&](glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) {
        addInstance(snapshot, quad(a, b, c, d), white);
    };
    add({x0, 0, 2}, {x1, 0, 2}, {x1, 0, -2}, {x0, 0, -2});
    add({x0, 3, -2}, {x1, 3, -2}, {x1, 3, 2}, {x0, 3, 2});
    add({x0, 0, -2}, {x1, 0, -2}, {x1, 3, -2}, {x0, 3, -2});
    add({x1, 0, 2}, {x0, 0, 2}, {x0, 3, 2}, {x1, 3, 2});
    add({x0, 0, 2}, {x0, 0, -2}, {x0, 3, -2}, {x0, 3, 2});
    add({x1, 0, -2}, {x1, 0, 2}, {x1, 3, 2}, {x1, 3, -2});
}

/// Two closed rooms of 4 m, a wall of 5 cm between them, light in the left one alone.
inline scene::SceneSnapshot twoClosedRooms() {
    scene::SceneSnapshot snapshot;
    addRoom(snapshot, -4.025f, -0.025f);
    addRoom(snapshot, 0.025f, 4.025f);
    addLight(snapshot, {-1.5f, 2.0f, 0.0f}, 0.1f, 200.0f);
    return snapshot;
}

}  // namespace lampyris::test
