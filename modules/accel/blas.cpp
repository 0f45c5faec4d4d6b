#include "accel/blas.h"

#include "accel/refit_cpu.h"

namespace lampyris::accel {
namespace {

using Corners = std::array<glm::vec3, 3>;

bool hasExactArea(const Corners& corners) {
    const glm::dvec3 a(corners[0]), b(corners[1]), c(corners[2]);
    const double area = glm::length(glm::cross(b - a, c - a));
    return std::isfinite(area) && area > 0.0;
}

bool isFinite(const glm::vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// Leaves that are the root become two: refits write boxes into an inner node.
void ensureInnerRoot(Tree& tree) {
    if (tree.rootLink == shared::BVH_NOTHING || !isLeaf(tree.rootLink)) return;
    const uint32_t count = leafCount(tree.rootLink);
    if (count == 1) tree.order.push_back(tree.order[0]);
    const uint32_t right = std::max(count - 1, 1u);
    tree.nodes = {{{}, leafLink(0, 1), {}, leafLink(1, right)}};
    tree.rootLink = 0;
    tree.depth = 1;
}

}  // namespace

core::Result<Blas> buildBlas(TreeBuilder& builder, const assets::Mesh& mesh) {
    const Triangles all{mesh.positions, mesh.indices};
    const BoxOf boxOf = [&all](uint32_t primitive, math::Bounds& box) {
        const Corners corners = all.corners(primitive);
        for (const glm::vec3& corner : corners) box.grow(corner);
        return hasExactArea(corners);
    };
    Blas blas;
    TRY(blas.tree, builder.build(all.count(), 4, boxOf));
    blas.dropped = all.count() - static_cast<uint32_t>(blas.tree.order.size());
    blas.triangles.reserve(blas.tree.order.size());
    for (const uint32_t primitive : blas.tree.order) {
        const auto [v0, v1, v2] = all.corners(primitive);
        blas.triangles.push_back({v0, primitive, v1, 0, v2, 0});
    }
    return blas;
}

core::Result<Blas> buildPosedBlas(TreeBuilder& builder, const Triangles& posed,
                                  const math::Bounds& bounds) {
    const glm::vec3 middle = bounds.empty() ? glm::vec3(0.0f) : bounds.centre();
    const BoxOf boxOf = [&](uint32_t primitive, math::Bounds& box) {
        for (const glm::vec3& corner : posed.corners(primitive))
            if (isFinite(corner)) box.grow(corner);
        if (box.empty()) box.grow(middle);
        return true;
    };
    Blas blas;
    TRY(blas.tree, builder.build(posed.count(), 4, boxOf));
    ensureInnerRoot(blas.tree);
    blas.tree.bounds = bounds;
    blas.tree.grid = gridAround(bounds);
    blas.triangles.resize(blas.tree.order.size());
    const auto corners = leafCorners(blas.tree, posed.indices);
    blas.dropped = refitOnCpu({blas.tree, 0, 0, blas.triangles, corners}, posed.positions).dropped;
    return blas;
}

}  // namespace lampyris::accel
