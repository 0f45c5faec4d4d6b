/// \file What an entity can have: plain values, no behaviour, no GPU types.
#pragma once

#include <cstdint>
#include <string>

#include "core/ids.h"
#include "math/glm.h"

namespace lampyris::scene {

using MeshId = core::Id<struct MeshTag>;          ///< a mesh of the world's Library
using MaterialId = core::Id<struct MaterialTag>;  ///< a material of the world's Library

struct Name {
    std::string value;
};

/// Local transform, relative to the parent entity (ecs hierarchy).
struct Transform {
    glm::vec3 translation{0.0f};  ///< metres
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
    glm::vec3 scale{1.0f};

    [[nodiscard]] glm::mat4 matrix() const {
        return glm::translate(glm::mat4(1.0f), translation) * glm::mat4_cast(rotation) *
               glm::scale(glm::mat4(1.0f), scale);
    }
};

/// Object to world; written by systems/world_transforms alone.
struct WorldTransform {
    glm::mat4 matrix{1.0f};
};

/// A mesh drawn with one material at the entity's world transform.
struct MeshInstance {
    MeshId mesh;
    MaterialId material;
};

/// A glowing sphere at the entity's origin. It neither blocks nor reflects light.
struct SphereLight {
    float radiusMetres = 0.05f;
    glm::vec3 powerWatts{0.0f};  ///< Φ a channel over the whole sphere
    float cosOuterCone =
        -1.0f;  ///< spot: no light outside; −1 is a full sphere. Axis: the entity's −z
    float cosInnerCone = -1.0f;  ///< spot: full light inside
};

/// A pinhole camera looking along the entity's −z.
struct Camera {
    float verticalFovRadians = 0.698132f;  ///< 40°
    float nearMetres = 0.01f;
};

}  // namespace lampyris::scene
