#include "reference/placed_mesh.h"

#include <algorithm>
#include <cmath>

namespace lampyris::reference {
namespace {

bool finite(const glm::mat4& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(matrix[column][row])) return false;
    return true;
}

/// The inverse transpose up to a positive factor; there is one for flattened instances as well.
glm::mat3 normalTransform(const glm::mat3& m, bool mirrored) {
    // In double: products of tiny scales leave the range of float.
    const glm::dmat3 d(m);
    glm::dmat3 cofactors(glm::cross(d[1], d[2]), glm::cross(d[2], d[0]), glm::cross(d[0], d[1]));
    double largest = 0.0;
    for (int column = 0; column < 3; ++column)
        largest = std::max(largest, glm::length(cofactors[column]));
    if (largest > 0.0) cofactors /= mirrored ? -largest : largest;
    return glm::mat3(cofactors);
}

bool finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// The mesh with its vertices where the pose puts them. Triangles that it puts at infinity are
/// left out.
std::shared_ptr<const assets::Mesh> pose(const assets::Mesh& mesh, const scene::Pose& pose) {
    scene::PosedVertices vertices = scene::posedVertices(mesh, pose);
    auto posed = std::make_shared<assets::Mesh>();
    posed->texcoords0 = mesh.texcoords0;
    posed->texcoords1 = mesh.texcoords1;
    posed->colours = mesh.colours;
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const uint32_t* corners = &mesh.indices[i];
        if (std::all_of(corners, corners + 3,
                        [&](uint32_t k) { return finite(vertices.positions[k]); }))
            posed->indices.insert(posed->indices.end(), corners, corners + 3);
    }
    for (glm::vec3& position : vertices.positions)
        if (!finite(position)) position = glm::vec3(0.0f);
    posed->positions = std::move(vertices.positions);
    posed->normals = std::move(vertices.normals);
    posed->tangents = std::move(vertices.tangents);
    return posed;
}

}  // namespace

std::optional<PlacedMesh> place(const scene::SceneSnapshot& snapshot,
                                const scene::SnapshotInstance& instance) {
    PlacedMesh placed;
    placed.mesh = snapshot.meshes[instance.mesh].value.get();
    if (instance.pose) placed.posed = pose(*placed.mesh, *instance.pose);
    if (placed.posed) placed.mesh = placed.posed.get();
    const assets::Mesh& mesh = *placed.mesh;
    if (mesh.triangleCount() == 0 || !finite(instance.objectToWorld)) return std::nullopt;
    placed.material = snapshot.materials[instance.material].value.get();
    placed.images = &snapshot.images;
    placed.toWorld = glm::mat3(instance.objectToWorld);
    placed.mirrored = glm::determinant(glm::dmat3(placed.toWorld)) < 0.0;
    placed.normalsToWorld = normalTransform(placed.toWorld, placed.mirrored);
    placed.positionsWorld.reserve(mesh.positions.size() + 1);
    for (const glm::vec3& position : mesh.positions)
        placed.positionsWorld.emplace_back(instance.objectToWorld * glm::vec4(position, 1.0f));
    placed.positionsWorld.emplace_back(0.0f);
    return placed;
}

MeshPoint::MeshPoint(const PlacedMesh& of, uint32_t triangle, float u, float v)
    : placed(&of),
      corners{of.mesh->indices[3 * size_t{triangle}], of.mesh->indices[3 * size_t{triangle} + 1],
              of.mesh->indices[3 * size_t{triangle} + 2]},
      weights(1.0f - u - v, u, v) {}

glm::vec3 MeshPoint::positionWorld() const {
    return mix(placed->positionsWorld, glm::vec3(0.0f));
}

void MeshPoint::keepFromEdges(float metres) {
    // Of triangles that are lower than a thousand times the distance, this sees but a part: there
    // are no walls between such.
    constexpr float kNear = 1e-3f;
    if (std::min({weights.x, weights.y, weights.z}) >= kNear) return;
    const auto& p = placed->positionsWorld;
    const float twiceArea = glm::length(acrossWorld());
    if (!(twiceArea > 0.0f)) return;
    for (int i = 0; i < 3; ++i) {
        const auto next = static_cast<size_t>((i + 1) % 3), last = static_cast<size_t>((i + 2) % 3);
        const float height = twiceArea / glm::length(p[corners[last]] - p[corners[next]]);
        weights[i] = std::max(weights[i], std::min(metres / height, 1.0f / 3.0f));
    }
    weights /= weights.x + weights.y + weights.z;
}

glm::vec3 MeshPoint::acrossWorld() const {
    const auto& p = placed->positionsWorld;
    const glm::vec3 across =
        glm::cross(p[corners[1]] - p[corners[0]], p[corners[2]] - p[corners[0]]);
    // glTF turns the winding of mirrored instances round, so that their front stays outside.
    return placed->mirrored ? -across : across;
}

glm::vec2 MeshPoint::texcoords(uint32_t set) const {
    return mix(set == 1 ? placed->mesh->texcoords1 : placed->mesh->texcoords0, glm::vec2(0.0f));
}

}  // namespace lampyris::reference
