/// \file Facts about triangle meshes that the tests ask for.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

#include "assets/mesh.h"

namespace lampyris::scene::test {

using Corner = std::array<float, 3>;

inline Corner cornerOf(const glm::vec3& p) {
    return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f};
}

/// How often each directed edge occurs, by position, so that meshes may be put together.
class EdgeCount {
 public:
    void add(const assets::Mesh& mesh) {
        for (size_t t = 0; t < mesh.indices.size(); t += 3) {
            for (size_t k = 0; k < 3; ++k) {
                const Corner from = cornerOf(mesh.positions[mesh.indices[t + k]]);
                const Corner to = cornerOf(mesh.positions[mesh.indices[t + (k + 1) % 3]]);
                ++edges_[{from, to}];
            }
        }
    }

    /// Edges without exactly one partner in the other direction: 0 for a closed, oriented surface.
    [[nodiscard]] size_t unpaired() const {
        size_t count = 0;
        for (const auto& [edge, times] : edges_) {
            const auto partner = edges_.find({edge.second, edge.first});
            if (times != 1 || partner == edges_.end() || partner->second != 1) ++count;
        }
        return count;
    }

 private:
    std::map<std::pair<Corner, Corner>, int> edges_;
};

inline double area(const assets::Mesh& mesh) {
    double sum = 0.0;
    for (size_t t = 0; t < mesh.indices.size(); t += 3) {
        const glm::dvec3 a(mesh.positions[mesh.indices[t]]);
        const glm::dvec3 b(mesh.positions[mesh.indices[t + 1]]);
        const glm::dvec3 c(mesh.positions[mesh.indices[t + 2]]);
        sum += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return sum;
}

/// The enclosed volume; positive where a closed surface faces outwards.
inline double volume(const assets::Mesh& mesh) {
    double sum = 0.0;
    for (size_t t = 0; t < mesh.indices.size(); t += 3) {
        const glm::dvec3 a(mesh.positions[mesh.indices[t]]);
        const glm::dvec3 b(mesh.positions[mesh.indices[t + 1]]);
        const glm::dvec3 c(mesh.positions[mesh.indices[t + 2]]);
        sum += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return sum;
}

/// Triangles whose area is zero, whose indices are out of range, or whose side by winding is not
/// the side of their vertices' normals; and normals that are not of length 1.
inline size_t flaws(const assets::Mesh& mesh) {
    size_t count = mesh.normals.size() == mesh.positions.size() ? 0 : 1;
    for (const glm::vec3& n : mesh.normals) {
        if (!(std::abs(glm::length(n) - 1.0f) < 1e-4f)) ++count;
    }
    for (size_t t = 0; t < mesh.indices.size(); t += 3) {
        const uint32_t* i = &mesh.indices[t];
        if (i[0] >= mesh.positions.size() || i[1] >= mesh.positions.size() ||
            i[2] >= mesh.positions.size()) {
            return count + 1;
        }
        const glm::dvec3 a(mesh.positions[i[0]]);
        const glm::dvec3 face =
            glm::cross(glm::dvec3(mesh.positions[i[1]]) - a, glm::dvec3(mesh.positions[i[2]]) - a);
        const glm::dvec3 normal(mesh.normals[i[0]] + mesh.normals[i[1]] + mesh.normals[i[2]]);
        if (!(glm::dot(face, normal) > 0.0)) ++count;
    }
    return count;
}

/// FNV-1a over the bytes of positions, normals and indices.
inline uint64_t hashOf(const assets::Mesh& mesh) {
    uint64_t hash = 0xcbf29ce484222325u;
    const auto mix = [&hash](const auto& values) {
        for (const auto& value : values) {
            std::array<uint32_t, sizeof(value) / 4> words;
            std::memcpy(words.data(), &value, sizeof(value));
            for (const uint32_t word : words) hash = (hash ^ word) * 0x100000001b3u;
        }
    };
    mix(mesh.positions);
    mix(mesh.normals);
    mix(mesh.indices);
    return hash;
}

}  // namespace lampyris::scene::test
