/// \file The tree of one mesh and its triangles in the order of the leaves.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "accel/tree_builder.h"
#include "assets/mesh.h"

namespace lampyris::accel {

/// A triangle as the texels of shared/bvh.h: three corners and its place in the mesh.
struct LeafTriangle {
    glm::vec3 v0{0.0f};
    uint32_t primitive = 0;
    glm::vec3 v1{0.0f};
    uint32_t pad0 = 0;
    glm::vec3 v2{0.0f};
    uint32_t pad1 = 0;
};
static_assert(sizeof(LeafTriangle) == shared::BVH_TRIANGLE_TEXELS * sizeof(glm::vec4));

struct Blas {
    Tree tree;                            ///< links relative to itself
    std::vector<LeafTriangle> triangles;  ///< in the order of the tree's leaves
    uint32_t dropped = 0;                 ///< triangles of the mesh that cannot be hit
};

/// Triangles in object space: three indices each.
struct Triangles {
    std::span<const glm::vec3> positions;
    std::span<const uint32_t> indices;
    [[nodiscard]] uint32_t count() const { return static_cast<uint32_t>(indices.size() / 3); }
    [[nodiscard]] std::array<glm::vec3, 3> corners(uint32_t primitive) const {
        const uint32_t* corner = &indices[3 * static_cast<size_t>(primitive)];
        return {positions[corner[0]], positions[corner[1]], positions[corner[2]]};
    }
};

/// Builds it. Triangles without area or with a corner that is not finite are left out.
core::Result<Blas> buildBlas(TreeBuilder& builder, const assets::Mesh& mesh);

/// Builds one that refits may follow: every triangle is in a leaf, as a later pose may make it
/// whole; the root is an inner node (of a single triangle, both of its children are that one). The
/// grid spans `bounds`, which should hold the triangles. Boxes and corners are a refit's: see
/// refit_cpu.h.
core::Result<Blas> buildPosedBlas(TreeBuilder& builder, const Triangles& posed,
                                  const math::Bounds& bounds);

}  // namespace lampyris::accel
