#include "assets/mesh_repair.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lampyris::assets {
namespace {

constexpr double kThinnest = 1e-7;  // [chosen] of the longest edge: a float's relative precision
constexpr uint32_t kUnused = 0xffffffffu;

template <typename Vector>
bool isFinite(const Vector& vector) {
    for (int c = 0; c < Vector::length(); ++c)
        if (!std::isfinite(vector[c])) return false;
    return true;
}

/// In doubles: floats of 1e30 have areas too.
bool hasArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const double doubleArea = glm::length(glm::cross(b - a, c - a));
    const double longest =
        std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    return doubleArea > kThinnest * longest * longest;
}

glm::vec3 faceNormal(const Mesh& mesh, const uint32_t* corners) {
    const glm::dvec3 a(mesh.positions[corners[0]]);
    const glm::dvec3 b(mesh.positions[corners[1]]);
    const glm::dvec3 c(mesh.positions[corners[2]]);
    const glm::dvec3 cross = glm::cross(b - a, c - a);
    const double length = glm::length(cross);
    return length > 0.0 ? glm::vec3(cross / length) : glm::vec3(0.0f, 1.0f, 0.0f);
}

template <typename Element>
void gather(std::vector<Element>& elements, const std::vector<uint32_t>& from) {
    if (elements.empty()) return;
    std::vector<Element> gathered(from.size());
    for (size_t i = 0; i < from.size(); ++i) gathered[i] = elements[from[i]];
    elements = std::move(gathered);
}

template <typename Vector>
void zeroWhereNonFinite(std::vector<Vector>& vectors, std::vector<bool>& changed) {
    for (size_t i = 0; i < vectors.size(); ++i) {
        if (isFinite(vectors[i])) continue;
        vectors[i] = Vector(0.0f);
        changed[i] = true;
    }
}

}  // namespace

DroppedTriangles dropBrokenTriangles(Mesh& mesh) {
    DroppedTriangles dropped;
    size_t kept = 0;
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const uint32_t corners[3] = {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
        const glm::vec3 &a = mesh.positions[corners[0]], &b = mesh.positions[corners[1]],
                        &c = mesh.positions[corners[2]];
        const bool pinched =
            corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
        if (!isFinite(a) || !isFinite(b) || !isFinite(c)) {
            ++dropped.nonFinite;
        } else if (pinched || (mesh.morphTargets.empty() && !hasArea(a, b, c))) {
            ++dropped.zeroArea;
        } else {
            std::copy_n(corners, 3, mesh.indices.begin() + static_cast<std::ptrdiff_t>(kept));
            kept += 3;
        }
    }
    mesh.indices.resize(kept);
    return dropped;
}

void gatherVertices(Mesh& mesh, const std::vector<uint32_t>& vertices) {
    gather(mesh.positions, vertices);
    gather(mesh.normals, vertices);
    gather(mesh.tangents, vertices);
    gather(mesh.texcoords0, vertices);
    gather(mesh.texcoords1, vertices);
    gather(mesh.colours, vertices);
    gather(mesh.joints, vertices);
    gather(mesh.weights, vertices);
    for (MorphTarget& target : mesh.morphTargets) {
        gather(target.positions, vertices);
        gather(target.normals, vertices);
    }
}

void dropUnusedVertices(Mesh& mesh) {
    std::vector<uint32_t> newIndex(mesh.positions.size(), kUnused);
    for (const uint32_t index : mesh.indices) newIndex[index] = 0;
    std::vector<uint32_t> used;
    for (uint32_t i = 0; i < newIndex.size(); ++i) {
        if (newIndex[i] == kUnused) continue;
        newIndex[i] = static_cast<uint32_t>(used.size());
        used.push_back(i);
    }
    if (used.size() == mesh.positions.size()) return;
    gatherVertices(mesh, used);
    for (uint32_t& index : mesh.indices) index = newIndex[index];
}

void makeFlatNormals(Mesh& mesh) {
    const std::vector<uint32_t> corners = mesh.indices;
    mesh.normals.clear();
    gatherVertices(mesh, corners);
    std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
    mesh.normals.resize(corners.size());
    for (size_t i = 0; i < corners.size(); i += 3)
        std::fill_n(mesh.normals.begin() + static_cast<std::ptrdiff_t>(i), 3,
                    faceNormal(mesh, &mesh.indices[i]));
}

uint32_t normalizeNormals(Mesh& mesh) {
    std::vector<bool> broken(mesh.normals.size(), false);
    uint32_t count = 0;
    for (size_t i = 0; i < mesh.normals.size(); ++i) {
        const glm::dvec3 normal(mesh.normals[i]);
        const double length = glm::length(normal);
        broken[i] = !std::isfinite(length) || length <= 0.0;
        if (broken[i])
            ++count;
        else
            mesh.normals[i] = glm::vec3(normal / length);
    }
    if (count == 0) return 0;
    for (size_t i = 0; i < mesh.indices.size(); ++i)
        if (broken[mesh.indices[i]])
            mesh.normals[mesh.indices[i]] = faceNormal(mesh, &mesh.indices[i / 3 * 3]);
    return count;
}

uint32_t zeroNonFinite(Mesh& mesh) {
    std::vector<bool> changed(mesh.positions.size(), false);
    zeroWhereNonFinite(mesh.tangents, changed);
    zeroWhereNonFinite(mesh.texcoords0, changed);
    zeroWhereNonFinite(mesh.texcoords1, changed);
    zeroWhereNonFinite(mesh.colours, changed);
    zeroWhereNonFinite(mesh.weights, changed);
    for (MorphTarget& target : mesh.morphTargets) {
        zeroWhereNonFinite(target.positions, changed);
        zeroWhereNonFinite(target.normals, changed);
    }
    return static_cast<uint32_t>(std::count(changed.begin(), changed.end(), true));
}

}  // namespace lampyris::assets
