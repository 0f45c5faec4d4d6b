/// \file A checked document on its way to a Model, and the readers of its parts. Private to assets.
#pragma once

#include <tiny_gltf.h>

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "assets/gltf_buffers.h"
#include "assets/gltf_context.h"
#include "assets/gltf_json.h"
#include "assets/model.h"

namespace lampyris::assets {

/// What the readers read: tinygltf's typed view of the JSON, and the bytes, both checked.
struct GltfSource {
    tinygltf::Model document;  ///< without buffers and images: those are read by this folder
    Json images;               ///< an object with the document's array `images`
    std::vector<GltfBuffer> buffers;
    std::optional<std::filesystem::path> folder;
    GltfContext& context;

    /// The bytes of a buffer view.
    [[nodiscard]] std::span<const uint8_t> view(int index) const;
};

/// Texture coordinates are transformed when a mesh is read, so that nothing later need know of
/// KHR_texture_transform: uv' = offset + rotate(scale · uv).
struct TextureTransform {
    glm::vec2 offset{0.0f};
    glm::vec2 scale{1.0f};
    float rotationRadians = 0.0f;

    bool operator==(const TextureTransform&) const = default;
    [[nodiscard]] glm::vec2 apply(glm::vec2 uv) const;
};

/// A texture coordinate set as a material reads it: one of the file's, transformed.
struct TexcoordSlot {
    uint32_t fileSet = 0;
    TextureTransform transform;
    bool used = false;
};

/// What a material asks of the meshes that wear it: their texcoords0 and texcoords1.
struct MaterialNeeds {
    TexcoordSlot slots[2] = {{0, {}, false}, {1, {}, false}};
    std::optional<uint32_t> tangentSlot;  ///< that of the normal map, if there is one
};

/// Fills Model::materials and Model::images; gives the needs of every material.
/// Behind the document's own materials stands glTF's default one, if some primitive names none.
core::Result<std::vector<MaterialNeeds>> readMaterials(GltfSource& source, Model& model);

/// Fills Model::meshes; gives for every glTF mesh what to draw.
core::Result<std::vector<std::vector<ModelPrimitive>>> readMeshes(
    GltfSource& source, const std::vector<MaterialNeeds>& needs, Model& model);

/// Fills Model::nodes, roots, cameras and lights.
core::Result<void> readNodes(GltfSource& source,
                             const std::vector<std::vector<ModelPrimitive>>& primitives,
                             Model& model);

/// Fills Model::skins. Errors: unreadable matrices, a vertex with a joint that its skin has not.
core::Result<void> readSkins(GltfSource& source, Model& model);

/// Fills Model::animations; one that makes no sense is left out with a warning.
void readAnimations(GltfSource& source, Model& model);

}  // namespace lampyris::assets
