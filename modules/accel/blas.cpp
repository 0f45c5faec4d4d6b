#include "accel/blas.h"

#include <array>

namespace lampyris::accel {
namespace {

using Corners = std::array<glm::vec3, 3>;

Corners cornersOf(const assets::Mesh& mesh, uint32_t primitive) {
    const uint32_t* corner = &mesh.indices[3 * static_cast<size_t>(primitive)];
    return {mesh.positions[corner[0]], mesh.positions[corner[1]], mesh.positions[corner[2]]};
}

bool hasArea(const Corners& corners) {
    const glm::dvec3 a(corners[0]), b(corners[1]), c(corners[2]);
    const double area = glm::length(glm::cross(b - a, c - a));
    return std::isfinite(area) && area > 0.0;
}

}  // namespace

core::Result<Blas> buildBlas(TreeBuilder& builder, const assets::Mesh& mesh) {
    const BoxOf boxOf = [&mesh](uint32_t primitive, math::Bounds& box) {
        const Corners corners = cornersOf(mesh, primitive);
        for (const glm::vec3& corner : corners) box.grow(corner);
        return hasArea(corners);
    };
    Blas blas;
    TRY(blas.tree, builder.build(mesh.triangleCount(), 4, boxOf));
    blas.triangles.reserve(blas.tree.order.size());
    for (const uint32_t primitive : blas.tree.order) {
        const auto [v0, v1, v2] = cornersOf(mesh, primitive);
        blas.triangles.push_back({v0, primitive, v1, 0, v2, 0});
    }
    return blas;
}

}  // namespace lampyris::accel
