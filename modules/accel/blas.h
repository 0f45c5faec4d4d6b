/// \file The tree of one mesh and its triangles in the order of the leaves.
#pragma once

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
};

/// Builds it. Triangles without area or with a corner that is not finite are left out.
core::Result<Blas> buildBlas(TreeBuilder& builder, const assets::Mesh& mesh);

}  // namespace lampyris::accel
