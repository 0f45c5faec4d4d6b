/// \file Scenes with an answer, and renders of them.
#pragma once

#include <gtest/gtest.h>

#include <string_view>

#include "reference/ray_scene.h"
#include "reference/reference.h"
#include "support/small_scenes.h"

namespace lampyris::reference {

using test::addInstance;
using test::addLight;
using test::lambertian;
using test::lookFrom;

inline Settings settingsFor(uint32_t width, uint32_t height, uint32_t samples) {
    Settings settings;
    settings.width = width;
    settings.height = height;
    settings.samplesPerPixel = samples;
    return settings;
}

inline Rendered rendered(const scene::SceneSnapshot& snapshot, const scene::SnapshotCamera& camera,
                         const Settings& settings) {
    auto result = render(snapshot, camera, settings);
    EXPECT_TRUE(result.ok());
    return std::move(result).value();
}

inline RayScene built(const scene::SceneSnapshot& snapshot) {
    auto scene = RayScene::build(snapshot);
    EXPECT_TRUE(scene.ok());
    return std::move(scene).value();
}

inline glm::vec3 pixelOf(const core::Image& image, uint32_t x, uint32_t y) {
    return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

inline glm::dvec3 meanOf(const core::Image& image) {
    glm::dvec3 sum(0.0);
    for (size_t i = 0; i < image.values.size(); i += 3)
        sum += glm::dvec3(image.values[i], image.values[i + 1], image.values[i + 2]);
    return sum * 3.0 / static_cast<double>(image.values.size());
}

/// A floor in the plane y = 0, 18 m wide.
inline assets::Mesh floorMesh() {
    return test::quad({-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, {-9, 0, -9});
}

/// The inside of a cube of half that side, front to the inside.
inline assets::Mesh boxFromInside(float half) {
    assets::Mesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-half, half}) {
            glm::vec3 centre(0.0f), u(0.0f), v(0.0f);
            centre[axis] = side;
            u[(axis + 1) % 3] = side;  // turned with the side, so that u × v points inwards
            v[(axis + 2) % 3] = -half;
            const auto first = static_cast<uint32_t>(mesh.positions.size());
            for (const auto& corner : {-u - v, u - v, u + v, v - u})
                mesh.positions.push_back(centre + corner);
            mesh.normals.insert(mesh.normals.end(), 4, -glm::normalize(centre));
            for (const uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + i);
        }
    return mesh;
}

inline assets::Material glowing(const glm::vec3& radiance,
                                const glm::vec3& albedo = glm::vec3(0.5f)) {
    assets::Material material = test::lambertian(albedo);
    material.emissiveRadiance = radiance;
    return material;
}

inline assets::Material metal(const glm::vec3& f0, float roughness) {
    assets::Material material;
    material.baseColour = glm::vec4(f0, 1.0f);
    material.metallic = 1.0f;
    material.roughness = roughness;
    return material;
}

}  // namespace lampyris::reference
