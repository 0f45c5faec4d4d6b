/// \file The world's meshes, materials and images: shared, immutable, replaced as a whole.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "assets/animation.h"
#include "assets/material.h"
#include "assets/mesh.h"
#include "scene/components.h"
#include "scene/pose.h"

namespace lampyris::scene {

/// A shared immutable value and a number that grows when it is replaced.
template <typename T>
struct Versioned {
    std::shared_ptr<const T> value;
    uint64_t version = 0;  ///< unique over the library's life: equal versions mean equal contents
};

/// What a MeshInstance without a material is drawn with. Not glTF's default, a white metal: that
/// would reflect no diffuse light, and diffuse light is all that bounces here.
constexpr MaterialId kDefaultMaterial{0};

/// Kept in the ecs::World as its resource. Entities refer to it by id.
class Library {
 public:
    /// Holds the default material (matt, albedo 0.8) as kDefaultMaterial, and nothing else.
    Library();
    MeshId addMesh(assets::Mesh mesh);
    MaterialId addMaterial(assets::Material material);
    int32_t addImage(assets::TextureImage image);
    ClipId addClip(assets::Animation clip);
    /// Puts other contents under an id; what shows it is told by version.
    void replaceMesh(MeshId id, assets::Mesh mesh);
    void replaceMaterial(MaterialId id, assets::Material material);

    [[nodiscard]] const std::vector<Versioned<assets::Mesh>>& meshes() const { return meshes_; }
    [[nodiscard]] const std::vector<Versioned<assets::Material>>& materials() const {
        return materials_;
    }
    [[nodiscard]] const std::vector<Versioned<assets::TextureImage>>& images() const {
        return images_;
    }
    /// Of a mesh that has joints or morph targets; null for the others.
    [[nodiscard]] const PoseExtents* extentsOf(MeshId id) const { return extents_[id.value].get(); }
    /// In the order of the file; an AnimationPlayer names one.
    [[nodiscard]] const std::vector<std::shared_ptr<const assets::Animation>>& clips() const {
        return clips_;
    }

 private:
    std::vector<Versioned<assets::Mesh>> meshes_;
    std::vector<std::shared_ptr<const PoseExtents>> extents_;  ///< by mesh
    std::vector<Versioned<assets::Material>> materials_;
    std::vector<Versioned<assets::TextureImage>> images_;
    std::vector<std::shared_ptr<const assets::Animation>> clips_;
    uint64_t lastVersion_ = 0;
};

}  // namespace lampyris::scene
