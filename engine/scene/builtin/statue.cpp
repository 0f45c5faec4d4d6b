#include "scene/builtin/statue.h"

#include <array>
#include <cmath>
#include <vector>

#include "scene/builtin/numbers.h"

namespace lampyris::scene::builtin {

namespace {

constexpr int kCells = 289;  ///< along an edge of the cube: 12 · 289² triangles

/// A smooth hill or dent of the sphere around a direction.
struct Bump {
    glm::vec3 direction;
    float height;     ///< of the radius
    float sharpness;  ///< larger is narrower
};

/// A face, as bumps that look good enough under a lamp [chosen by eye].
constexpr std::array<Bump, 17> kFace{{
    {{0.00f, -0.05f, 1.00f}, 0.22f, 60.0f},   // bridge of the nose
    {{0.00f, -0.20f, 0.98f}, 0.26f, 90.0f},   // tip of the nose
    {{0.12f, -0.24f, 0.96f}, 0.07f, 200.0f},  // nostrils
    {{-0.12f, -0.24f, 0.96f}, 0.07f, 200.0f},
    {{0.33f, 0.10f, 0.94f}, -0.20f, 45.0f},  // eye sockets
    {{-0.33f, 0.10f, 0.94f}, -0.20f, 45.0f},
    {{0.32f, 0.08f, 0.94f}, 0.10f, 160.0f},  // eyes
    {{-0.32f, 0.08f, 0.94f}, 0.10f, 160.0f},
    {{0.30f, 0.28f, 0.91f}, 0.13f, 40.0f},  // brows
    {{-0.30f, 0.28f, 0.91f}, 0.13f, 40.0f},
    {{0.45f, -0.25f, 0.86f}, 0.12f, 25.0f},  // cheeks
    {{-0.45f, -0.25f, 0.86f}, 0.12f, 25.0f},
    {{0.00f, -0.42f, 0.91f}, 0.12f, 90.0f},  // lips
    {{0.00f, -0.50f, 0.87f}, -0.06f, 150.0f},
    {{0.00f, -0.70f, 0.71f}, 0.22f, 25.0f},  // chin
    {{1.00f, 0.00f, 0.00f}, 0.16f, 40.0f},   // ears
    {{-1.00f, 0.00f, 0.00f}, 0.16f, 40.0f},
}};

float bumpAt(const Bump& bump, const glm::vec3& direction) {
    const float away = 1.0f - glm::dot(direction, glm::normalize(bump.direction));
    const float falloff = 1.0f / (1.0f + bump.sharpness * away);
    return bump.height * falloff * falloff * falloff;
}

float latticeValue(const glm::ivec3& cell) {
    const auto x = static_cast<uint32_t>(cell.x);
    const auto y = static_cast<uint32_t>(cell.y);
    return hashSigned(hashBits(x, y), static_cast<uint32_t>(cell.z));
}

/// Value noise in [−1, 1], smooth in its first derivative.
float noiseAt(const glm::vec3& p) {
    const glm::vec3 base = glm::floor(p);
    const glm::vec3 t = p - base;
    const glm::vec3 s = t * t * (3.0f - 2.0f * t);
    const glm::ivec3 cell(base);
    float sum = 0.0f;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 offset(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::vec3 weight(offset.x != 0 ? s.x : 1.0f - s.x, offset.y != 0 ? s.y : 1.0f - s.y,
                               offset.z != 0 ? s.z : 1.0f - s.z);
        sum += weight.x * weight.y * weight.z * latticeValue(cell + offset);
    }
    return sum;
}

/// Curls where hair grows: on top and behind.
float hairAt(const glm::vec3& direction) {
    const float share = glm::clamp(4.0f * (direction.y - 0.9f * direction.z) - 1.0f, 0.0f, 1.0f);
    if (share <= 0.0f) return 0.0f;
    const float curl = noiseAt(9.0f * direction + glm::vec3(40.0f));
    return share * (0.07f + 0.10f * (0.5f - std::abs(curl)));
}

glm::vec3 surfaceAt(const glm::vec3& onCube) {
    const glm::vec3 direction = glm::normalize(onCube);
    float radius = 1.0f + hairAt(direction);
    for (const Bump& bump : kFace) radius += bumpAt(bump, direction);
    radius += 0.015f * noiseAt(7.0f * direction) + 0.004f * noiseAt(31.0f * direction);
    radius += 0.0012f * noiseAt(120.0f * direction);
    const glm::vec3 stretched = direction * radius * glm::vec3(1.65f, 2.4f, 1.85f);
    return stretched + glm::vec3(0.0f, 2.4f, 0.0f);
}

/// Odd in its argument to the last bit, so that faces meet without cracks.
float cubeStep(int step) {
    return static_cast<float>(2 * step - kCells) / kCells;
}

glm::vec3 pointOnCube(int axis, float side, int column, int row) {
    glm::vec3 p;
    p[axis] = side;
    p[(axis + 1) % 3] = side * cubeStep(column);
    p[(axis + 2) % 3] = cubeStep(row);
    return p;
}

/// One face of the cube, blown up. Normals come from a grid one vertex wider on each side, so that
/// neighbouring faces agree at their seam.
void addFace(assets::Mesh& mesh, int axis, float side) {
    constexpr int kWide = kCells + 3;
    std::vector<glm::vec3> grid;
    grid.reserve(static_cast<size_t>(kWide) * kWide);
    for (int row = -1; row <= kCells + 1; ++row) {
        for (int column = -1; column <= kCells + 1; ++column) {
            grid.push_back(surfaceAt(pointOnCube(axis, side, column, row)));
        }
    }
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    for (int row = 0; row <= kCells; ++row) {
        for (int column = 0; column <= kCells; ++column) {
            const size_t at =
                static_cast<size_t>(row + 1) * kWide + static_cast<size_t>(column) + 1;
            mesh.positions.push_back(grid[at]);
            mesh.normals.push_back(glm::normalize(
                glm::cross(grid[at + 1] - grid[at - 1], grid[at + kWide] - grid[at - kWide])));
        }
    }
    for (int row = 0; row < kCells; ++row) {
        for (int column = 0; column < kCells; ++column) {
            const uint32_t a = first + static_cast<uint32_t>(row * (kCells + 1) + column);
            const uint32_t d = a + kCells + 1;
            mesh.indices.insert(mesh.indices.end(), {a, a + 1, d + 1, a, d + 1, d});
        }
    }
}

}  // namespace

assets::Mesh makeStatue() {
    assets::Mesh mesh;
    mesh.name = "statue";
    for (int axis = 0; axis < 3; ++axis) {
        addFace(mesh, axis, -1.0f);
        addFace(mesh, axis, 1.0f);
    }
    float lowest = 0.0f;
    float highest = 0.0f;
    for (const glm::vec3& p : mesh.positions) {
        lowest = glm::min(lowest, p.y);
        highest = glm::max(highest, p.y);
    }
    const float scale = 5.0f / (highest - lowest);
    for (glm::vec3& p : mesh.positions) p = (p - glm::vec3(0.0f, lowest, 0.0f)) * scale;
    assets::updateBounds(mesh);
    return mesh;
}

}  // namespace lampyris::scene::builtin
