/// \file Ways for a mesh's vertices to move that a refit must follow.
#pragma once

#include <limits>
#include <random>
#include <vector>

#include "accel/blas.h"
#include "accel/refit_cpu.h"
#include "support/snapshot_builder.h"

namespace lampyris::test {

enum class Deformation { None, Small, Scatter, Teleport, Flip, Flatten, Break };
constexpr Deformation kDeformations[] = {
    Deformation::None, Deformation::Small,   Deformation::Scatter, Deformation::Teleport,
    Deformation::Flip, Deformation::Flatten, Deformation::Break,   Deformation::Small};

/// The rest positions deformed. Break makes some corners infinite or not a number; Flatten takes
/// the area of some triangles.
inline std::vector<glm::vec3> deformed(const assets::Mesh& mesh, Deformation how, uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    const auto point = [&] { return glm::vec3(uniform(random), uniform(random), uniform(random)); };
    std::vector<glm::vec3> positions = mesh.positions;
    const glm::vec3 away = 50.0f * point();
    for (size_t i = 0; i < positions.size(); ++i) {
        glm::vec3& p = positions[i];
        if (how == Deformation::Small) p += 0.05f * point();
        if (how == Deformation::Scatter) p = 3.0f * point();
        if (how == Deformation::Teleport) p += away;
        if (how == Deformation::Flip) p = glm::vec3(-p.x, p.z, p.y);
        if (how == Deformation::Flatten && i % 9 >= 3 && i % 9 < 6) p = positions[i / 9 * 9];
        if (how == Deformation::Break && i % 7 == 0) p.y = std::numeric_limits<float>::quiet_NaN();
        if (how == Deformation::Break && i % 31 == 0) p.x = std::numeric_limits<float>::infinity();
    }
    return positions;
}

/// Around the finite corners, as posedBounds() has it.
inline math::Bounds finiteBounds(const std::vector<glm::vec3>& positions) {
    math::Bounds bounds;
    for (const glm::vec3& p : positions)
        if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) bounds.grow(p);
    return bounds;
}

/// A tree for the mesh at rest that refits may follow.
inline accel::Blas posedBlasOf(const assets::Mesh& mesh) {
    accel::TreeBuilder builder;
    auto blas = accel::buildPosedBlas(builder, {mesh.positions, mesh.indices},
                                      finiteBounds(mesh.positions));
    if (!blas.ok()) throw std::runtime_error(blas.error().message);
    return std::move(blas).value();
}

/// Refits on the CPU, over the positions' own grid. \return triangles without area
inline uint32_t refitTo(accel::Blas& blas, const assets::Mesh& mesh,
                        const std::vector<glm::vec3>& positions) {
    blas.tree.bounds = finiteBounds(positions);
    blas.tree.grid = accel::gridAround(blas.tree.bounds);
    const auto corners = accel::leafCorners(blas.tree, mesh.indices);
    return accel::refitOnCpu({blas.tree, 0, 0, blas.triangles, corners}, positions).dropped;
}

}  // namespace lampyris::test
