/// \file A binary BVH over boxes, in the form that shaders read.
#pragma once

#include <cstdint>
#include <vector>

#include "math/bounds.h"
#include "shared/bvh.h"

namespace lampyris::accel {

/// A box in whole cells of a grid: lower in the low half of each word, upper in the high half.
struct CellBox {
    uint32_t x = 0, y = 0, z = 0;
};

/// Both children of an inner node: their boxes and where they lead. As the texels of shared/bvh.h.
struct Node {
    CellBox leftBox;
    uint32_t leftLink = shared::BVH_NOTHING;
    CellBox rightBox;
    uint32_t rightLink = shared::BVH_NOTHING;
};
static_assert(sizeof(Node) == shared::BVH_NODE_TEXELS * 4 * sizeof(uint32_t));

/// The grid of a tree with these bounds. Cells are never smaller than the rounding of a ray's
/// arithmetic.
[[nodiscard]] shared::GpuBvhGrid gridAround(const math::Bounds& bounds);
/// The box in cells, and a cell wider on every side, so that rounding in the shader's slab test
/// cannot miss what the exact triangle test would hit.
[[nodiscard]] CellBox toCells(const shared::GpuBvhGrid& grid, const math::Bounds& box);
[[nodiscard]] math::Bounds fromCells(const shared::GpuBvhGrid& grid, const CellBox& box);

/// Nodes stand in preorder, the root first. Leaves are ranges of `order`.
struct Tree {
    std::vector<Node> nodes;
    std::vector<uint32_t> order;  ///< the caller's primitives, leaf by leaf, ascending in each
    uint32_t rootLink = shared::BVH_NOTHING;  ///< BVH_NOTHING where there is no primitive
    uint32_t depth = 0;  ///< most inner nodes on a path: stack entries of a walk
    math::Bounds bounds;
    shared::GpuBvhGrid grid{};
};

[[nodiscard]] inline bool isLeaf(uint32_t link) {
    return (link & shared::BVH_LEAF) != 0;
}
[[nodiscard]] inline uint32_t leafCount(uint32_t link) {
    return ((link >> shared::BVH_COUNT_SHIFT) & 3u) + 1;
}
[[nodiscard]] inline uint32_t linkIndex(uint32_t link) {
    return link & shared::BVH_INDEX_MASK;
}
[[nodiscard]] inline uint32_t leafLink(uint32_t first, uint32_t count) {
    return shared::BVH_LEAF | ((count - 1) << shared::BVH_COUNT_SHIFT) | first;
}

/// Adds offsets to a link that is relative to its own tree.
[[nodiscard]] uint32_t relocated(uint32_t link, uint32_t nodeOffset, uint32_t leafOffset);

/// Does so to every link of the tree, the root's too.
void relocate(Tree& tree, uint32_t nodeOffset, uint32_t leafOffset);

}  // namespace lampyris::accel
