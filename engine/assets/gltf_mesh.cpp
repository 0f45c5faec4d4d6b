#include <algorithm>
#include <cmath>

#include "assets/gltf_primitive.h"
#include "assets/mesh_repair.h"
#include "assets/tangents.h"

namespace lampyris::assets {
namespace {

constexpr float kWeightSumTolerance = 0.01f;  // [chosen] above what 8-bit weights round to

/// Bytes of the attributes of one vertex, tangents left out.
uint64_t vertexBytes(const Mesh& mesh) {
    uint64_t bytes = sizeof(glm::vec3) * (2 + 2 * mesh.morphTargets.size());
    bytes += mesh.texcoords0.empty() ? 0 : sizeof(glm::vec2);
    bytes += mesh.texcoords1.empty() ? 0 : sizeof(glm::vec2);
    bytes += mesh.colours.empty() ? 0 : sizeof(glm::vec4);
    bytes += mesh.weights.empty() ? 0 : sizeof(glm::vec4) + sizeof(glm::uvec4);
    return bytes;
}

/// Brings one primitive after the other from what stands in the file to what Mesh promises.
class MeshReader {
 public:
    explicit MeshReader(GltfSource& source) : source_(source), context_(source.context) {}

    /// Nothing where no triangle is left.
    core::Result<std::optional<Mesh>> read(const tinygltf::Mesh& owner, size_t primitive,
                                           const MaterialNeeds& needs, const std::string& place) {
        place_ = place;
        TRY(std::optional<Mesh> read,
            readPrimitive(source_, owner.primitives[primitive], needs, place));
        if (!read) return std::optional<Mesh>{};
        Mesh& mesh = *read;
        mesh.name =
            owner.primitives.size() == 1 ? owner.name : fmt::format("{} {}", owner.name, primitive);
        repairTriangles(mesh);
        if (mesh.indices.empty()) return std::optional<Mesh>{};
        TRY_VOID(completeNormals(mesh));
        normalizeWeights(mesh);
        completeTexcoords(mesh, needs);
        zeroAttributes(mesh);
        TRY_VOID(completeTangents(mesh, needs));
        completeMorphWeights(mesh, owner.weights);
        updateBounds(mesh);
        return read;
    }

    /// One line for all: exporters' spheres have such triangles at their poles.
    void warnOfZeroArea() {
        if (zeroAreaTriangles_ > 0)
            context_.warn("", "{} triangles without area in {} meshes are left out",
                          zeroAreaTriangles_, zeroAreaMeshes_);
    }

 private:
    void repairTriangles(Mesh& mesh) {
        const DroppedTriangles dropped = dropBrokenTriangles(mesh);
        if (dropped.nonFinite > 0)
            context_.warn(place_, "mesh {}: {} triangles at NaN or infinity are left out",
                          mesh.name, dropped.nonFinite);
        zeroAreaTriangles_ += dropped.zeroArea;
        zeroAreaMeshes_ += dropped.zeroArea > 0 ? 1 : 0;
        dropUnusedVertices(mesh);
    }

    core::Result<void> completeNormals(Mesh& mesh) {
        if (!mesh.normals.empty()) {
            const uint32_t broken = normalizeNormals(mesh);
            if (broken > 0)
                context_.warn(place_, "mesh {}: {} normals have no direction; a face's stands in",
                              mesh.name, broken);
            return {};
        }
        TRY_VOID(context_.takeBytes(place_, mesh.indices.size() * vertexBytes(mesh)));
        mesh.tangents.clear();  // glTF 2.0, 3.7.2.1: without normals, tangents are void
        for (MorphTarget& target : mesh.morphTargets) target.normals.clear();
        makeFlatNormals(mesh);
        return {};
    }

    /// Four weights that sum to 1, and joint 0 where the weight is 0.
    void normalizeWeights(Mesh& mesh) {
        uint32_t off = 0;
        for (size_t i = 0; i < mesh.weights.size(); ++i) {
            const glm::vec4 weights = glm::max(mesh.weights[i], glm::vec4(0.0f));
            const float sum = weights.x + weights.y + weights.z + weights.w;
            const bool usable = sum > 0.0f && std::isfinite(sum);
            if (!usable || std::abs(sum - 1.0f) > kWeightSumTolerance) ++off;
            mesh.weights[i] = usable ? weights / sum : glm::vec4(1.0f, 0.0f, 0.0f, 0.0f);
            for (int c = usable ? 0 : 1; c < 4; ++c)
                if (mesh.weights[i][c] <= 0.0f) mesh.joints[i][c] = 0;
        }
        if (off > 0)
            context_.warn(place_,
                          "mesh {}: the joint weights of {} vertices do not sum to 1; made to",
                          mesh.name, off);
    }

    void completeTexcoords(Mesh& mesh, const MaterialNeeds& needs) {
        std::vector<glm::vec2>* sets[2] = {&mesh.texcoords0, &mesh.texcoords1};
        for (int i = 0; i < 2; ++i) {
            const TexcoordSlot& slot = needs.slots[i];
            if (slot.used && sets[i]->empty())
                context_.warn(place_,
                              "mesh {} has no TEXCOORD_{}, which its material reads; 0 stands in",
                              mesh.name, slot.fileSet);
            for (glm::vec2& uv : *sets[i]) uv = slot.transform.apply(uv);
        }
    }

    void zeroAttributes(Mesh& mesh) {
        const uint32_t zeroed = zeroNonFinite(mesh);
        if (zeroed > 0)
            context_.warn(place_, "mesh {}: {} vertices have attributes that are not finite, now 0",
                          mesh.name, zeroed);
    }

    core::Result<void> completeTangents(Mesh& mesh, const MaterialNeeds& needs) {
        if (!mesh.tangents.empty()) {
            normalizeTangents(mesh);
            return {};
        }
        if (!needs.tangentSlot) return {};
        const auto& texcoords = *needs.tangentSlot == 0 ? mesh.texcoords0 : mesh.texcoords1;
        if (texcoords.empty()) return {};
        TRY_VOID(context_.takeBytes(place_, mesh.positions.size() * sizeof(glm::vec4) * 3));
        generateTangents(mesh, *needs.tangentSlot);
        return {};
    }

    void completeMorphWeights(Mesh& mesh, const std::vector<double>& weights) {
        if (!weights.empty() && weights.size() != mesh.morphTargets.size())
            context_.warn(place_, "mesh {} has {} weights for {} morph targets", mesh.name,
                          weights.size(), mesh.morphTargets.size());
        mesh.morphWeights.assign(weights.begin(), weights.end());
        mesh.morphWeights.resize(mesh.morphTargets.size(), 0.0f);
    }

    GltfSource& source_;
    GltfContext& context_;
    std::string place_;
    uint64_t zeroAreaTriangles_ = 0;
    uint32_t zeroAreaMeshes_ = 0;
};

}  // namespace

core::Result<std::vector<std::vector<ModelPrimitive>>> readMeshes(
    GltfSource& source, const std::vector<MaterialNeeds>& needs, Model& model) {
    MeshReader reader(source);
    std::vector<std::vector<ModelPrimitive>> primitives;
    for (const tinygltf::Mesh& owner : source.document.meshes) {
        std::vector<ModelPrimitive>& drawn = primitives.emplace_back();
        for (size_t i = 0; i < owner.primitives.size(); ++i) {
            const std::string place =
                fmt::format("/meshes/{}/primitives/{}", primitives.size() - 1, i);
            const int named = owner.primitives[i].material;
            const auto material =
                named >= 0 ? static_cast<uint32_t>(named) : static_cast<uint32_t>(needs.size() - 1);
            TRY(std::optional<Mesh> mesh, reader.read(owner, i, needs[material], place));
            if (!mesh) continue;
            drawn.push_back({static_cast<uint32_t>(model.meshes.size()), material});
            model.meshes.push_back(std::move(*mesh));
        }
    }
    reader.warnOfZeroArea();
    if (model.meshes.empty()) return source.context.error("", "has no mesh that can be drawn");
    return primitives;
}

}  // namespace lampyris::assets
