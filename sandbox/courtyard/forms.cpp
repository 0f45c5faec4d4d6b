#include "courtyard/forms.h"

#include <array>
#include <vector>

#include "scene/builtin/numbers.h"
#include "scene/builtin/shapes.h"

namespace lampyris::courtyard {

using scene::builtin::SinCos;
using scene::builtin::sinCosTurns;

glm::quat turned(const glm::vec3& axis, double turns) {
    const SinCos half = sinCosTurns(0.5 * turns);
    const auto s = static_cast<float>(half.sin);
    return {static_cast<float>(half.cos), s * axis.x, s * axis.y, s * axis.z};
}

void addGrid(assets::Mesh& mesh, uint32_t first, uint32_t columns, uint32_t rows, bool wraps) {
    for (uint32_t row = 0; row + 1 < rows; ++row) {
        for (uint32_t column = 0; column + (wraps ? 0 : 1) < columns; ++column) {
            const uint32_t a = first + row * columns + column;
            const uint32_t b = first + row * columns + (column + 1) % columns;
            mesh.indices.insert(mesh.indices.end(),
                                {a, b, b + columns, a, b + columns, a + columns});
        }
    }
}

void smoothNormals(assets::Mesh& mesh, uint32_t first) {
    mesh.normals.resize(mesh.positions.size(), glm::vec3(0.0f));
    for (size_t v = first; v < mesh.normals.size(); ++v) mesh.normals[v] = glm::vec3(0.0f);
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const uint32_t* corner = &mesh.indices[i];
        if (corner[0] < first) continue;
        const glm::vec3& a = mesh.positions[corner[0]];
        const glm::vec3 area =
            glm::cross(mesh.positions[corner[1]] - a, mesh.positions[corner[2]] - a);
        for (int k = 0; k < 3; ++k) mesh.normals[corner[k]] += area;
    }
    for (size_t v = first; v < mesh.normals.size(); ++v) {
        const float length = glm::length(mesh.normals[v]);
        mesh.normals[v] = length > 0.0f ? mesh.normals[v] / length : glm::vec3(0.0f, 1.0f, 0.0f);
    }
}

void addLathe(assets::Mesh& mesh, const glm::mat4& placement, std::span<const glm::vec2> profile,
              uint32_t sides) {
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    for (size_t i = 0; i < profile.size(); ++i) {
        const glm::vec2 along =
            profile[i + 1 < profile.size() ? i + 1 : i] - profile[i > 0 ? i - 1 : 0];
        const glm::vec2 out = glm::normalize(glm::vec2(along.y, -along.x));
        for (uint32_t side = 0; side < sides; ++side) {
            const SinCos angle = sinCosTurns(-static_cast<double>(side) / sides);
            const glm::vec3 around(static_cast<float>(angle.cos), 0.0f,
                                   static_cast<float>(angle.sin));
            const glm::vec3 point = profile[i].x * around + glm::vec3(0.0f, profile[i].y, 0.0f);
            const glm::vec3 normal = out.x * around + glm::vec3(0.0f, out.y, 0.0f);
            mesh.positions.emplace_back(placement * glm::vec4(point, 1.0f));
            mesh.normals.push_back(glm::normalize(glm::vec3(placement * glm::vec4(normal, 0.0f))));
        }
    }
    for (uint32_t i = 0; i + 1 < profile.size(); ++i)
        if (profile[i] != profile[i + 1]) addGrid(mesh, first + i * sides, sides, 2, true);
}

void addBlock(assets::Mesh& mesh, const glm::vec3& lower, const glm::vec3& upper,
              float edgeRadius) {
    scene::builtin::addRoundedBox(mesh, scene::builtin::placed(0.5f * (lower + upper)),
                                  {0.5f * (upper - lower), edgeRadius, 1, 1});
}

void addArch(assets::Mesh& mesh, const glm::mat4& placement, const ArchForm& form) {
    constexpr int kSegments = 24;
    const float radius = 0.5f * form.width;
    const auto at = [&](float x, float y, float z) {
        return glm::vec3(placement * glm::vec4(x, y, z, 1.0f));
    };
    const auto onArch = [&](int i) {
        const SinCos angle = sinCosTurns(0.5 - 0.5 * i / kSegments);
        return glm::vec2(radius * static_cast<float>(angle.cos),
                         form.topY - 0.02f - radius + radius * static_cast<float>(angle.sin));
    };
    using scene::builtin::addQuad;
    const float z = 0.5f * form.depth;
    const float top = form.topY;
    const float spring = onArch(0).y;
    addQuad(mesh, at(-radius, top, z), at(radius, top, z), at(radius, top, -z),
            at(-radius, top, -z));
    addQuad(mesh, at(radius, spring, z), at(radius, spring, -z), at(radius, top, -z),
            at(radius, top, z));
    addQuad(mesh, at(-radius, spring, -z), at(-radius, spring, z), at(-radius, top, z),
            at(-radius, top, -z));
    for (int i = 0; i < kSegments; ++i) {
        const glm::vec2 a = onArch(i);
        const glm::vec2 b = onArch(i + 1);
        addQuad(mesh, at(a.x, a.y, z), at(b.x, b.y, z), at(b.x, top, z), at(a.x, top, z));
        addQuad(mesh, at(b.x, b.y, -z), at(a.x, a.y, -z), at(a.x, top, -z), at(b.x, top, -z));
        addQuad(mesh, at(a.x, a.y, -z), at(b.x, b.y, -z), at(b.x, b.y, z), at(a.x, a.y, z));
    }
}

void addBar(assets::Mesh& mesh, const glm::vec3& a, const glm::vec3& b, float radius,
            uint32_t sides) {
    const std::array<glm::vec3, 2> path{a, b};
    scene::builtin::addTube(mesh, path, radius, sides);
}

}  // namespace lampyris::courtyard
