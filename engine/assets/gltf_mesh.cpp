#include <algorithm>
#include <cmath>

#include "assets/gltf_primitive.h"
#include "assets/mesh_repair.h"
#include "assets/tangents.h"

namespace lampyris::assets {
namespace {

constexpr float kWeightSumTolerance = 0.01f;  // [chosen] above what 8-bit weights round to

void repairTriangles(Mesh& mesh, GltfContext& context, const std::string& place) {
    const DroppedTriangles dropped = dropBrokenTriangles(mesh);
    if (dropped.nonFinite > 0)
        context.warn(place, "mesh {}: {} triangles at NaN or infinity are left out", mesh.name,
                     dropped.nonFinite);
    if (dropped.zeroArea > 0)
        context.warn(place, "mesh {}: {} triangles without area are left out", mesh.name,
                     dropped.zeroArea);
    dropUnusedVertices(mesh);
    const uint32_t zeroed = zeroNonFinite(mesh);
    if (zeroed > 0)
        context.warn(place, "mesh {}: {} vertices have attributes that are not finite, now 0",
                     mesh.name, zeroed);
}

/// Bytes of the vertex attributes for one vertex.
uint64_t vertexBytes(const Mesh& mesh) {
    uint64_t bytes = sizeof(glm::vec3) * (2 + 2 * mesh.morphTargets.size());
    bytes += mesh.texcoords0.empty() ? 0 : sizeof(glm::vec2);
    bytes += mesh.texcoords1.empty() ? 0 : sizeof(glm::vec2);
    bytes += mesh.colours.empty() ? 0 : sizeof(glm::vec4);
    bytes += mesh.weights.empty() ? 0 : sizeof(glm::vec4) + sizeof(glm::uvec4);
    return bytes;
}

core::Result<void> completeNormals(Mesh& mesh, GltfContext& context, const std::string& place) {
    if (!mesh.normals.empty()) {
        const uint32_t broken = normalizeNormals(mesh);
        if (broken > 0)
            context.warn(place, "mesh {}: {} normals have no direction; their face's stands in",
                         mesh.name, broken);
        return {};
    }
    TRY_VOID(context.takeBytes(place, mesh.indices.size() * vertexBytes(mesh)));
    mesh.tangents
        .clear();  // glTF 2.0, 3.7.2.1: without normals, tangents and their targets are void
    for (MorphTarget& target : mesh.morphTargets) target.normals.clear();
    makeFlatNormals(mesh);
    return {};
}

/// Four weights that sum to 1, and joint 0 where the weight is 0.
void normalizeWeights(Mesh& mesh, GltfContext& context, const std::string& place) {
    uint32_t off = 0;
    for (size_t i = 0; i < mesh.weights.size(); ++i) {
        glm::vec4& weights = mesh.weights[i];
        weights = glm::max(weights, glm::vec4(0.0f));
        const float sum = weights.x + weights.y + weights.z + weights.w;
        if (!(std::abs(sum - 1.0f) <= kWeightSumTolerance)) ++off;
        weights = sum > 0.0f && std::isfinite(sum) ? weights / sum : glm::vec4(1, 0, 0, 0);
        for (int c = 0; c < 4; ++c)
            if (weights[c] <= 0.0f) mesh.joints[i][c] = 0;
    }
    if (off > 0)
        context.warn(place, "mesh {}: the joint weights of {} vertices do not sum to 1; made to",
                     mesh.name, off);
}

void completeTexcoords(Mesh& mesh, const MaterialNeeds& needs, GltfContext& context,
                       const std::string& place) {
    std::vector<glm::vec2>* sets[2] = {&mesh.texcoords0, &mesh.texcoords1};
    for (int set = 0; set < 2; ++set) {
        if (needs.uses[set] && sets[set]->empty())
            context.warn(place, "mesh {} has no TEXCOORD_{}, which its material reads; 0 stands in",
                         mesh.name, set);
        for (glm::vec2& uv : *sets[set]) uv = needs.transforms[set].apply(uv);
    }
}

core::Result<void> completeTangents(Mesh& mesh, const MaterialNeeds& needs, GltfContext& context,
                                    const std::string& place) {
    if (!mesh.tangents.empty()) {
        normalizeTangents(mesh);
        return {};
    }
    if (!needs.tangentSet) return {};
    const auto& texcoords = *needs.tangentSet == 0 ? mesh.texcoords0 : mesh.texcoords1;
    if (texcoords.empty()) return {};
    TRY_VOID(context.takeBytes(place, mesh.positions.size() * sizeof(glm::vec4) * 3));
    generateTangents(mesh, *needs.tangentSet);
    return {};
}

void completeMorphWeights(Mesh& mesh, const std::vector<double>& weights, GltfContext& context,
                          const std::string& place) {
    if (!weights.empty() && weights.size() != mesh.morphTargets.size())
        context.warn(place, "mesh {} has {} weights for {} morph targets", mesh.name,
                     weights.size(), mesh.morphTargets.size());
    mesh.morphWeights.assign(weights.begin(), weights.end());
    mesh.morphWeights.resize(mesh.morphTargets.size(), 0.0f);
}

/// From what stands in the file to what Mesh promises. Nothing where no triangle is left.
core::Result<std::optional<Mesh>> readMesh(GltfSource& source, const tinygltf::Mesh& owner,
                                           size_t primitive, const MaterialNeeds& needs,
                                           const std::string& place) {
    TRY(std::optional<Mesh> read, readPrimitive(source, owner.primitives[primitive], place));
    if (!read) return std::optional<Mesh>{};
    Mesh& mesh = *read;
    mesh.name =
        owner.primitives.size() == 1 ? owner.name : fmt::format("{} {}", owner.name, primitive);
    repairTriangles(mesh, source.context, place);
    if (mesh.indices.empty()) return std::optional<Mesh>{};
    TRY_VOID(completeNormals(mesh, source.context, place));
    normalizeWeights(mesh, source.context, place);
    completeTexcoords(mesh, needs, source.context, place);
    TRY_VOID(completeTangents(mesh, needs, source.context, place));
    completeMorphWeights(mesh, owner.weights, source.context, place);
    updateBounds(mesh);
    return read;
}

}  // namespace

core::Result<std::vector<std::vector<ModelPrimitive>>> readMeshes(
    GltfSource& source, const std::vector<MaterialNeeds>& needs, Model& model) {
    std::vector<std::vector<ModelPrimitive>> primitives;
    for (const tinygltf::Mesh& owner : source.document.meshes) {
        std::vector<ModelPrimitive>& drawn = primitives.emplace_back();
        for (size_t i = 0; i < owner.primitives.size(); ++i) {
            const std::string place =
                fmt::format("/meshes/{}/primitives/{}", primitives.size() - 1, i);
            const int named = owner.primitives[i].material;
            const auto material =
                named >= 0 ? static_cast<uint32_t>(named) : static_cast<uint32_t>(needs.size() - 1);
            TRY(std::optional<Mesh> mesh, readMesh(source, owner, i, needs[material], place));
            if (!mesh) continue;
            drawn.push_back({static_cast<uint32_t>(model.meshes.size()), material});
            model.meshes.push_back(std::move(*mesh));
        }
    }
    if (model.meshes.empty()) return source.context.error("", "has no mesh that can be drawn");
    return primitives;
}

}  // namespace lampyris::assets
