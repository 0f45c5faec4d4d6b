/// \file An instance of the snapshot where it stands in the world.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "scene/snapshot.h"

namespace lampyris::reference {

/// A mesh in world space, its material, and the images that the material names. Points into the
/// snapshot, which must outlive it; a posed mesh is its own.
struct PlacedMesh {
    std::shared_ptr<const assets::Mesh> posed;  ///< null: at rest
    const assets::Mesh* mesh = nullptr;         ///< as it is drawn
    const assets::Material* material = nullptr;
    const std::vector<scene::Versioned<assets::TextureImage>>* images = nullptr;
    glm::mat3 toWorld{1.0f};                ///< of tangents
    glm::mat3 normalsToWorld{1.0f};         ///< of normals; not unit
    bool mirrored = false;                  ///< triangles turn the other way round in the world
    std::vector<glm::vec3> positionsWorld;  ///< with one more at the end, which Embree may read
};

/// Nothing where there is no triangle, or the transform is not finite.
[[nodiscard]] std::optional<PlacedMesh> place(const scene::SceneSnapshot& snapshot,
                                              const scene::SnapshotInstance& instance);

/// A point of a triangle; u and v are the weights of its second and third corner.
struct MeshPoint {
    MeshPoint(const PlacedMesh& placed, uint32_t triangle, float u, float v);

    /// An attribute there; `absent` where the mesh has none.
    template <typename T>
    [[nodiscard]] T mix(const std::vector<T>& attribute, const T& absent) const {
        if (attribute.empty()) return absent;
        return weights.x * attribute[corners[0]] + weights.y * attribute[corners[1]] +
               weights.z * attribute[corners[2]];
    }
    [[nodiscard]] glm::vec3 positionWorld() const;
    /// Moves a point that is nearer to an edge than that: by rounding it may lie beyond the wall
    /// that meets the triangle there.
    void keepFromEdges(float metres);
    /// Across the triangle, to its front side; its length is twice the area in square metres.
    [[nodiscard]] glm::vec3 acrossWorld() const;
    [[nodiscard]] glm::vec2 texcoords(uint32_t set) const;

    const PlacedMesh* placed;
    std::array<uint32_t, 3> corners;
    glm::vec3 weights;
};

}  // namespace lampyris::reference
