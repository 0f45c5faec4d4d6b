/// \file The neck of the hourglass: all that a renderer may know of the world, immutable, on the
/// CPU.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ecs/entity.h"
#include "math/bounds.h"
#include "scene/library.h"
#include "scene/pose.h"

namespace lampyris::scene {

/// A mesh in the world. `version` grows when anything here or the mesh's contents change; contents
/// of its material are told by SceneSnapshot::materialVersion.
struct SnapshotInstance {
    ecs::Entity entity;
    uint32_t mesh = 0;              ///< into SceneSnapshot::meshes
    uint32_t material = 0;          ///< into SceneSnapshot::materials
    glm::mat4 objectToWorld{1.0f};  ///< of a skinned one: where its joints' common ancestor stands
    uint64_t version = 0;
    math::Bounds boundsWorld{};          ///< around the transformed box of the mesh, as posed
    std::shared_ptr<const Pose> pose{};  ///< null: the mesh at rest, shared with other instances
    uint64_t poseVersion = 0;            ///< equal versions of an entity mean equal pose and mesh
};

struct SnapshotLight {
    ecs::Entity entity;
    glm::vec3 positionWorld{0.0f};
    float radiusMetres = 0.05f;
    glm::vec3 powerWatts{0.0f};  ///< over the whole sphere, as if there were no cone
    glm::vec3 directionWorld{0.0f, 0.0f, -1.0f};
    float cosOuterCone = -1.0f;
    float cosInnerCone = -1.0f;
    uint64_t version = 0;
};

struct SnapshotCamera {
    std::string name;
    glm::mat4 cameraToWorld{1.0f};  ///< rigid
    float verticalFovRadians = 0.698132f;
    float nearMetres = 0.01f;
};

/// Entries keep their index while their entity lives in the snapshot's order (by entity index).
struct SceneSnapshot {
    std::vector<Versioned<assets::Mesh>> meshes;
    std::vector<Versioned<assets::Material>> materials;
    std::vector<Versioned<assets::TextureImage>> images;
    std::vector<SnapshotInstance> instances;
    std::vector<SnapshotLight> lights;
    std::vector<SnapshotCamera> cameras;
    math::Bounds boundsWorld;
    uint64_t geometryVersion = 0;  ///< grows when instances or meshes change
    uint64_t lightVersion = 0;     ///< grows when a light changes
    uint64_t materialVersion = 0;  ///< grows when a material or image changes
};

}  // namespace lampyris::scene
