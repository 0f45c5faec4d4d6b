/// \file What an entity can have: plain values, no behaviour, no GPU types.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/ids.h"
#include "ecs/entity.h"
#include "math/glm.h"

namespace lampyris::scene {

using MeshId = core::Id<struct MeshTag>;          ///< a mesh of the world's Library
using MaterialId = core::Id<struct MaterialTag>;  ///< a material of the world's Library
using ClipId = core::Id<struct ClipTag>;          ///< an animation of the world's Library

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

/// A part of what its parent shows, in a material of its own: who points at it means the parent.
struct MeshPart {};

/// Weights of the mesh's morph targets. Those that are missing count as 0; what is too many, not.
/// An entity that has it is deformed: it has vertices, and a BVH, of its own.
struct MorphWeights {
    std::vector<float> values;
};

/// Joints that the mesh's vertices follow, whatever becomes of the entity's own Transform. An
/// entity that has it is deformed.
struct Skin {
    std::vector<ecs::Entity> joints;             ///< by the joint numbers of the mesh's vertices
    std::vector<glm::mat4> inverseBindMatrices;  ///< as many: mesh space at rest to joint space
};

/// Plays a clip: sets Transform and MorphWeights of its targets from the world's FrameTime.
struct AnimationPlayer {
    ClipId clip;                       ///< invalid: plays nothing
    std::vector<ecs::Entity> targets;  ///< by the node numbers of the clip's channels
    double startSeconds = 0.0;         ///< of FrameTime, where the clip's second 0 is
    double speed = 1.0;                ///< clip seconds a second; may be negative
    bool loops = false;                ///< otherwise it holds its ends
};

/// Walks from waypoint to waypoint at an even pace; systems/patrol.h places it by FrameTime.
struct Patrol {
    std::vector<glm::vec3> waypoints;  ///< of Transform::translation
    float metresPerSecond = 1.0f;      ///< negative: the other way
    double startSeconds = 0.0;         ///< of FrameTime, at the first waypoint
    bool closed = true;                ///< on from the last to the first; otherwise to and fro
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
