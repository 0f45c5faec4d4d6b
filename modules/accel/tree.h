/// \file A binary BVH over boxes, in the form that shaders read.
#pragma once

#include <cstdint>
#include <vector>

#include "math/bounds.h"
#include "shared/bvh.h"

namespace lampyris::accel {

/// Both children of an inner node: their boxes and where they lead. As the texels of shared/bvh.h.
struct Node {
    glm::vec3 leftLower{0.0f};
    uint32_t leftLink = shared::BVH_NOTHING;
    glm::vec3 leftUpper{0.0f};
    uint32_t rightLink = shared::BVH_NOTHING;
    glm::vec3 rightLower{0.0f};
    uint32_t pad0 = 0;
    glm::vec3 rightUpper{0.0f};
    uint32_t pad1 = 0;
};
static_assert(sizeof(Node) == shared::BVH_NODE_TEXELS * sizeof(glm::vec4));

/// Nodes stand in preorder, the root first. Leaves are ranges of `order`.
struct Tree {
    std::vector<Node> nodes;
    std::vector<uint32_t> order;  ///< the caller's primitives, leaf by leaf, ascending in each
    uint32_t rootLink = shared::BVH_NOTHING;  ///< BVH_NOTHING where there is no primitive
    uint32_t depth = 0;  ///< most inner nodes on a path: stack entries of a walk
    math::Bounds bounds;
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
