#include "scene/builtin/shapes.h"

#include <cmath>

#include "core/check.h"
#include "scene/builtin/numbers.h"

namespace lampyris::scene::builtin {

namespace {

uint32_t addVertex(assets::Mesh& mesh, const glm::vec3& position, const glm::vec3& normal) {
    mesh.positions.push_back(position);
    mesh.normals.push_back(normal);
    return static_cast<uint32_t>(mesh.positions.size() - 1);
}

uint32_t vertexCount(const assets::Mesh& mesh) {
    return static_cast<uint32_t>(mesh.positions.size());
}

/// Triangles of a grid whose vertices begin at `first`, row by row; each row and column may wrap.
struct GridIndices {
    uint32_t first;
    uint32_t columns;  ///< cells
    uint32_t rows;     ///< cells
    bool wrapColumns;
    bool wrapRows;
};
void addGridIndices(assets::Mesh& mesh, const GridIndices& grid) {
    const uint32_t vertexColumns = grid.columns + (grid.wrapColumns ? 0 : 1);
    const uint32_t vertexRows = grid.rows + (grid.wrapRows ? 0 : 1);
    for (uint32_t row = 0; row < grid.rows; ++row) {
        for (uint32_t column = 0; column < grid.columns; ++column) {
            const uint32_t right = (column + 1) % vertexColumns;
            const uint32_t above = (row + 1) % vertexRows;
            const uint32_t a = grid.first + row * vertexColumns + column;
            const uint32_t b = grid.first + row * vertexColumns + right;
            const uint32_t c = grid.first + above * vertexColumns + right;
            const uint32_t d = grid.first + above * vertexColumns + column;
            mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
        }
    }
}

/// Places along one axis of a rounded box: denser in the rounded ends, by equal angles.
std::vector<float> roundedSteps(float halfExtent, const RoundedBox& box) {
    std::vector<float> steps;
    const float inner = halfExtent - box.edgeRadius;
    const auto cornerOffset = [&](uint32_t step) {
        const SinCos angle = sinCosTurns(0.125 * step / box.cornerSteps);
        return box.edgeRadius * static_cast<float>(angle.sin / angle.cos);
    };
    for (uint32_t i = box.cornerSteps; i > 0; --i) steps.push_back(-inner - cornerOffset(i));
    for (uint32_t i = 0; i <= box.flatSteps; ++i) {
        const float t = box.flatSteps == 0 ? 0.5f : static_cast<float>(i) / box.flatSteps;
        steps.push_back(inner * (2.0f * t - 1.0f));
    }
    for (uint32_t i = 1; i <= box.cornerSteps; ++i) steps.push_back(inner + cornerOffset(i));
    return steps;
}

}  // namespace

glm::mat4 placed(const glm::vec3& translation, double yawDegrees) {
    const SinCos yaw = sinCosTurns(yawDegrees / 360.0);
    const auto s = static_cast<float>(yaw.sin);
    const auto c = static_cast<float>(yaw.cos);
    return {glm::vec4(c, 0.0f, -s, 0.0f), glm::vec4(0.0f, 1.0f, 0.0f, 0.0f),
            glm::vec4(s, 0.0f, c, 0.0f), glm::vec4(translation, 1.0f)};
}

void addQuad(assets::Mesh& mesh, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
             const glm::vec3& d) {
    const glm::vec3 normal = glm::normalize(glm::cross(b - a, c - a));
    const uint32_t first = addVertex(mesh, a, normal);
    addVertex(mesh, b, normal);
    addVertex(mesh, c, normal);
    addVertex(mesh, d, normal);
    mesh.indices.insert(mesh.indices.end(),
                        {first, first + 1, first + 2, first, first + 2, first + 3});
}

void addBox(assets::Mesh& mesh, const glm::mat4& placement, const glm::vec3& halfExtent) {
    const auto corner = [&](float x, float y, float z) {
        return glm::vec3(placement * glm::vec4(halfExtent * glm::vec3(x, y, z), 1.0f));
    };
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0f, 1.0f}) {
            const auto at = [&](float u, float v) {
                glm::vec3 p;
                p[axis] = side;
                p[(axis + 1) % 3] = side * u;
                p[(axis + 2) % 3] = v;
                return corner(p.x, p.y, p.z);
            };
            addQuad(mesh, at(-1, -1), at(1, -1), at(1, 1), at(-1, 1));
        }
    }
}

assets::Mesh boxMesh(const glm::vec3& halfExtent) {
    assets::Mesh mesh;
    mesh.name = "box";
    addBox(mesh, glm::mat4(1.0f), halfExtent);
    assets::updateBounds(mesh);
    return mesh;
}

void addRoundedBox(assets::Mesh& mesh, const glm::mat4& placement, const RoundedBox& box) {
    const glm::vec3 inner = box.halfExtent - box.edgeRadius;
    const float smallestInner = glm::min(inner.x, glm::min(inner.y, inner.z));
    CHECK((box.flatSteps == 0 ? inner == glm::vec3(0.0f) : smallestInner > 0.0f));
    const std::vector<float> steps[3] = {roundedSteps(box.halfExtent.x, box),
                                         roundedSteps(box.halfExtent.y, box),
                                         roundedSteps(box.halfExtent.z, box)};
    const auto cells = static_cast<uint32_t>(steps[0].size() - 1);
    const auto addFaceVertex = [&](int axis, float side, uint32_t column, uint32_t row) {
        glm::vec3 onBox;
        onBox[axis] = side * steps[axis].back();  // not halfExtent: bits must meet at the edges
        onBox[(axis + 1) % 3] = steps[(axis + 1) % 3][side > 0.0f ? column : cells - column];
        onBox[(axis + 2) % 3] = steps[(axis + 2) % 3][row];
        const glm::vec3 core = glm::clamp(onBox, -inner, inner);
        const glm::vec3 normal = glm::normalize(onBox - core);
        addVertex(mesh, glm::vec3(placement * glm::vec4(core + box.edgeRadius * normal, 1.0f)),
                  glm::vec3(placement * glm::vec4(normal, 0.0f)));
    };
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0f, 1.0f}) {
            const uint32_t first = vertexCount(mesh);
            for (uint32_t row = 0; row <= cells; ++row) {
                for (uint32_t column = 0; column <= cells; ++column) {
                    addFaceVertex(axis, side, column, row);
                }
            }
            addGridIndices(mesh, {first, cells, cells, false, false});
        }
    }
}

void addSphere(assets::Mesh& mesh, const glm::vec3& centre, float radius, uint32_t steps) {
    CHECK((steps % 2) == 0u);
    addRoundedBox(mesh, placed(centre), {glm::vec3(radius), radius, steps / 2, 0});
}

void addCylinder(assets::Mesh& mesh, const glm::mat4& placement, float radius, float height,
                 uint32_t sides) {
    const auto addRing = [&](float y, float normalY) {
        for (uint32_t i = 0; i < sides; ++i) {
            const SinCos angle = sinCosTurns(-static_cast<double>(i) / sides);
            const glm::vec3 out(static_cast<float>(angle.cos), 0.0f, static_cast<float>(angle.sin));
            const glm::vec3 normal = normalY == 0.0f ? out : glm::vec3(0.0f, normalY, 0.0f);
            addVertex(mesh, glm::vec3(placement * glm::vec4(radius * out.x, y, radius * out.z, 1)),
                      glm::vec3(placement * glm::vec4(normal, 0.0f)));
        }
    };
    const uint32_t first = vertexCount(mesh);
    addRing(0.0f, 0.0f);
    addRing(height, 0.0f);
    addGridIndices(mesh, {first, sides, 1, true, false});
    const uint32_t bottom = vertexCount(mesh);
    addRing(0.0f, -1.0f);
    addRing(height, 1.0f);
    for (uint32_t i = 1; i + 1 < sides; ++i) {
        mesh.indices.insert(mesh.indices.end(), {bottom, bottom + i + 1, bottom + i});
        const uint32_t top = bottom + sides;
        mesh.indices.insert(mesh.indices.end(), {top, top + i, top + i + 1});
    }
}

void addTorus(assets::Mesh& mesh, const glm::mat4& placement, float radius, float tubeRadius,
              uint32_t around, uint32_t across) {
    const uint32_t first = vertexCount(mesh);
    for (uint32_t row = 0; row < across; ++row) {
        const SinCos tube = sinCosTurns(static_cast<double>(row) / across);
        for (uint32_t column = 0; column < around; ++column) {
            const SinCos ring = sinCosTurns(-static_cast<double>(column) / around);
            const glm::vec3 out(static_cast<float>(ring.cos), 0.0f, static_cast<float>(ring.sin));
            const glm::vec3 normal = static_cast<float>(tube.cos) * out +
                                     glm::vec3(0.0f, static_cast<float>(tube.sin), 0.0f);
            addVertex(mesh,
                      glm::vec3(placement * glm::vec4(radius * out + tubeRadius * normal, 1.0f)),
                      glm::vec3(placement * glm::vec4(normal, 0.0f)));
        }
    }
    addGridIndices(mesh, {first, around, across, true, true});
}

void addTube(assets::Mesh& mesh, std::span<const glm::vec3> path, float radius, uint32_t sides) {
    const auto directionAt = [&](size_t i) {
        const size_t before = i == 0 ? 0 : i - 1;
        const size_t after = i + 1 == path.size() ? i : i + 1;
        return glm::normalize(path[after] - path[before]);
    };
    const uint32_t first = vertexCount(mesh);
    const glm::vec3 start = directionAt(0);
    // The frame is carried along the path, so that the tube does not twist.
    glm::vec3 side = std::abs(start.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    for (size_t i = 0; i < path.size(); ++i) {
        const glm::vec3 direction = directionAt(i);
        side = glm::normalize(side - direction * glm::dot(side, direction));
        const glm::vec3 up = glm::cross(direction, side);
        for (uint32_t k = 0; k < sides; ++k) {
            const SinCos angle = sinCosTurns(static_cast<double>(k) / sides);
            const glm::vec3 normal =
                side * static_cast<float>(angle.cos) + up * static_cast<float>(angle.sin);
            addVertex(mesh, path[i] + radius * normal, normal);
        }
    }
    addGridIndices(mesh, {first, sides, static_cast<uint32_t>(path.size() - 1), true, false});
}

}  // namespace lampyris::scene::builtin
