#include "assets/gltf_primitive.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "assets/gltf_accessor.h"
#include "assets/triangulate.h"

namespace lampyris::assets {
namespace {

using Attributes = std::map<std::string, int>;

/// Reads attributes over the vertices that the triangles need.
struct VertexReader {
    GltfSource& source;
    const std::string& place;
    size_t vertexCount;  ///< of the whole primitive
    ElementRange range;

    /// The attribute's accessor, −1 where it is absent. Error: not as long as the positions.
    [[nodiscard]] core::Result<int> find(const Attributes& attributes,
                                         const std::string& name) const {
        const auto found = attributes.find(name);
        if (found == attributes.end()) return -1;
        const size_t count = allOf(source, found->second).count;
        if (count != vertexCount)
            return source.context.error(place, "{} has {} elements, and there are {} vertices",
                                        name, count, vertexCount);
        return found->second;
    }

    /// The attribute's values, none where it is absent.
    template <typename Vector>
    [[nodiscard]] core::Result<std::vector<Vector>> read(const Attributes& attributes,
                                                         const std::string& name) const {
        TRY(const int accessor, find(attributes, name));
        if (accessor < 0) return std::vector<Vector>{};
        return readVectors<Vector>(source, accessor, range);
    }
};

core::Result<std::vector<uint32_t>> readTriangles(GltfSource& source,
                                                  const tinygltf::Primitive& primitive,
                                                  const std::string& place, size_t vertexCount) {
    std::vector<uint32_t> indices;
    if (primitive.indices >= 0) {
        TRY(indices, readUnsigned(source, primitive.indices, 1, allOf(source, primitive.indices)));
    } else {
        TRY_VOID(source.context.takeBytes(place, uint64_t{vertexCount} * sizeof(uint32_t)));
        indices.resize(vertexCount);
        std::iota(indices.begin(), indices.end(), 0u);
    }
    const auto wrong = std::find_if(indices.begin(), indices.end(),
                                    [&](uint32_t index) { return index >= vertexCount; });
    if (wrong != indices.end())
        return source.context.error(place, "index {} is {}, and there are {} vertices",
                                    wrong - indices.begin(), *wrong, vertexCount);
    const bool isList = primitive.mode == TINYGLTF_MODE_TRIANGLES;
    if (isList && indices.size() % 3 != 0)
        source.context.warn(place, "{} indices are left over", indices.size() % 3);
    if (!isList) TRY_VOID(source.context.takeBytes(place, indices.size() * 3 * sizeof(uint32_t)));
    return triangulate(std::move(indices), isList ? Topology::List
                                           : primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP
                                               ? Topology::Strip
                                               : Topology::Fan);
}

/// Moves the indices down to begin at 0; gives the vertices that they spanned.
ElementRange rebase(std::vector<uint32_t>& indices) {
    const auto [lowest, highest] = std::minmax_element(indices.begin(), indices.end());
    const ElementRange range{*lowest, size_t{*highest} - *lowest + 1};
    for (uint32_t& index : indices) index -= static_cast<uint32_t>(range.first);
    return range;
}

core::Result<void> readColours(const VertexReader& reader, const Attributes& attributes,
                               Mesh& mesh) {
    TRY(const int accessor, reader.find(attributes, "COLOR_0"));
    if (accessor < 0) return {};
    const tinygltf::Accessor& colours =
        reader.source.document.accessors[static_cast<size_t>(accessor)];
    if (componentCount(colours) == 4) {
        TRY(mesh.colours, reader.read<glm::vec4>(attributes, "COLOR_0"));
        return {};
    }
    TRY(const std::vector<glm::vec3> rgb, reader.read<glm::vec3>(attributes, "COLOR_0"));
    mesh.colours.reserve(rgb.size());
    for (const glm::vec3& colour : rgb) mesh.colours.emplace_back(colour, 1.0f);
    return {};
}

core::Result<void> readJoints(const VertexReader& reader, const Attributes& attributes,
                              Mesh& mesh) {
    TRY(const int joints, reader.find(attributes, "JOINTS_0"));
    TRY(const int weights, reader.find(attributes, "WEIGHTS_0"));
    if (attributes.contains("JOINTS_1"))
        reader.source.context.warn(reader.place, "only four joints a vertex are read");
    if ((joints < 0) != (weights < 0))
        reader.source.context.warn(reader.place, "has only one of JOINTS_0 and WEIGHTS_0");
    if (joints < 0 || weights < 0) return {};
    TRY(mesh.weights, reader.read<glm::vec4>(attributes, "WEIGHTS_0"));
    TRY(const std::vector<uint32_t> values, readUnsigned(reader.source, joints, 4, reader.range));
    mesh.joints.resize(reader.range.count);
    for (size_t i = 0; i < mesh.joints.size(); ++i)
        mesh.joints[i] = {values[4 * i], values[4 * i + 1], values[4 * i + 2], values[4 * i + 3]};
    return {};
}

core::Result<void> readTargets(const VertexReader& reader, const tinygltf::Primitive& primitive,
                               Mesh& mesh) {
    for (size_t i = 0; i < primitive.targets.size(); ++i) {
        const std::string place = fmt::format("{}/targets/{}", reader.place, i);
        const VertexReader targetReader{reader.source, place, reader.vertexCount, reader.range};
        MorphTarget target;
        TRY(target.positions, targetReader.read<glm::vec3>(primitive.targets[i], "POSITION"));
        TRY(target.normals, targetReader.read<glm::vec3>(primitive.targets[i], "NORMAL"));
        mesh.morphTargets.push_back(std::move(target));
    }
    return {};
}

std::string texcoordName(const TexcoordSlot& slot) {
    return fmt::format("TEXCOORD_{}", slot.fileSet);
}

}  // namespace

core::Result<std::optional<Mesh>> readPrimitive(GltfSource& source,
                                                const tinygltf::Primitive& primitive,
                                                const MaterialNeeds& needs,
                                                const std::string& place) {
    const Attributes& attributes = primitive.attributes;
    if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
        source.context.warn(place, "points and lines are not drawn");
        return std::optional<Mesh>{};
    }
    const auto positions = attributes.find("POSITION");
    if (positions == attributes.end()) {
        source.context.warn(place, "has no POSITION and is not drawn");
        return std::optional<Mesh>{};
    }
    const size_t vertexCount = allOf(source, positions->second).count;
    Mesh mesh;
    TRY(mesh.indices, readTriangles(source, primitive, place, vertexCount));
    if (mesh.indices.empty()) {
        source.context.warn(place, "has no triangle and is not drawn");
        return std::optional<Mesh>{};
    }
    const VertexReader reader{source, place, vertexCount, rebase(mesh.indices)};
    TRY(mesh.positions, reader.read<glm::vec3>(attributes, "POSITION"));
    TRY(mesh.normals, reader.read<glm::vec3>(attributes, "NORMAL"));
    TRY(mesh.tangents, reader.read<glm::vec4>(attributes, "TANGENT"));
    TRY(mesh.texcoords0, reader.read<glm::vec2>(attributes, texcoordName(needs.slots[0])));
    TRY(mesh.texcoords1, reader.read<glm::vec2>(attributes, texcoordName(needs.slots[1])));
    TRY_VOID(readColours(reader, attributes, mesh));
    TRY_VOID(readJoints(reader, attributes, mesh));
    TRY_VOID(readTargets(reader, primitive, mesh));
    return std::optional<Mesh>{std::move(mesh)};
}

}  // namespace lampyris::assets
