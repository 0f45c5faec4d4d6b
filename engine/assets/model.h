/// \file A glTF file on the CPU: indices in range, numbers finite, the nodes a forest.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assets/animation.h"
#include "assets/material.h"
#include "assets/mesh.h"
#include "math/glm.h"

namespace lampyris::assets {

/// One mesh drawn with one material; indices into the model.
struct ModelPrimitive {
    uint32_t mesh = 0;
    uint32_t material = 0;
};

/// A node of the hierarchy. −1 is none.
struct ModelNode {
    std::string name;
    int32_t parent = -1;
    std::vector<uint32_t> children;
    glm::vec3 translation{0.0f};  ///< metres, relative to the parent
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
    glm::vec3 scale{1.0f};
    std::vector<ModelPrimitive> primitives;
    int32_t camera = -1;
    int32_t light = -1;
    int32_t skin = -1;
    std::optional<float> lightRadiusMetres;  ///< the node's extras.radius, before the light's
    std::vector<float> morphWeights;         ///< in place of the mesh's where not empty
};

/// A perspective camera that looks along its node's −z.
struct ModelCamera {
    std::string name;
    float verticalFovRadians = 0.698132f;
    float nearMetres = 0.01f;
};

enum class LightType : uint8_t { Point, Spot, Directional };

/// KHR_lights_punctual: shines from its node's origin; spot and directional along −z.
/// A point light's power is 4π · intensity · colour, in watts.
struct ModelLight {
    std::string name;
    LightType type = LightType::Point;
    glm::vec3 colour{1.0f};         ///< linear
    float intensity = 1.0f;         ///< W/sr; directional: W/m²
    float rangeMetres = 0.0f;       ///< 0 is without limit
    float innerConeRadians = 0.0f;  ///< spot: half angle of full light
    float outerConeRadians = 0.785398f;
    float radiusMetres = 0.05f;  ///< the light's extras.radius
};

/// A skeleton for skinned meshes.
struct ModelSkin {
    std::string name;
    std::vector<uint32_t> joints;                ///< nodes
    std::vector<glm::mat4> inverseBindMatrices;  ///< as many as joints
};

/// What a file holds. Behind the file's own materials stands glTF's default one, if some primitive
/// names none.
struct Model {
    std::string name;
    std::vector<Mesh> meshes;  ///< one a drawable primitive
    std::vector<Material> materials;
    std::vector<TextureImage> images;
    std::vector<ModelNode> nodes;
    std::vector<ModelCamera> cameras;
    std::vector<ModelLight> lights;
    std::vector<ModelSkin> skins;
    std::vector<Animation> animations;
    std::vector<uint32_t> roots;  ///< nodes of the default scene that have no parent in it
};

}  // namespace lampyris::assets
