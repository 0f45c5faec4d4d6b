/// \file A binary BVH over boxes, in the form that shaders read.
#pragma once

#include <algorithm>
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
/// From coordinates to whole cells: a product with the cell's reciprocal, so that a device rounds
/// as the CPU does [as lib/refit.glsl, bit for bit].
class CellScale {
 public:
    explicit CellScale(const shared::GpuBvhGrid& grid)
        : offset_(grid.offset), perMetre_(1.0f / glm::vec3(grid.cell)) {}
    /// What a box of that many metres is in cells, wider by one to two on every side.
    [[nodiscard]] CellBox operator()(const math::Bounds& box) const {
        const glm::vec3 lower = (box.lower - offset_) * perMetre_;
        const glm::vec3 upper = (box.upper - offset_) * perMetre_;
        return {pack(lower.x, upper.x), pack(lower.y, upper.y), pack(lower.z, upper.z)};
    }
    [[nodiscard]] const glm::vec3& perMetre() const { return perMetre_; }

 private:
    static uint32_t pack(float lower, float upper) {
        const auto low = static_cast<int32_t>(std::clamp(lower, 1.0f, 65535.0f)) - 1;
        const auto high = static_cast<int32_t>(std::clamp(upper, 0.0f, 65533.0f)) + 2;
        return static_cast<uint32_t>(low) | (static_cast<uint32_t>(high) << 16);
    }
    glm::vec3 offset_, perMetre_;
};

/// The box of nothing: a point at the grid's end, outside of every other box.
constexpr CellBox kNoBox{0xffffffffu, 0xffffffffu, 0xffffffffu};

/// The smallest box around both; kNoBox counts for nothing.
[[nodiscard]] inline CellBox united(const CellBox& a, const CellBox& b) {
    if (a.x == kNoBox.x) return b;
    if (b.x == kNoBox.x) return a;
    const auto axis = [](uint32_t p, uint32_t q) {
        return std::min(p & 0xffffu, q & 0xffffu) | (std::max(p >> 16, q >> 16) << 16);
    };
    return {axis(a.x, b.x), axis(a.y, b.y), axis(a.z, b.z)};
}

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
