/// \file New corners and boxes for a tree whose triangles moved, on the CPU; links stay. The twin
/// of the nodes in refit_nodes.h: the same vertices give the same bits.
#pragma once

#include "accel/blas.h"

namespace lampyris::accel {

/// What a refit rewrites. The tree's grid must hold the triangles.
struct RefitTarget {
    Tree& tree;  ///< boxes
    uint32_t firstNode = 0;
    uint32_t firstTriangle = 0;         ///< what relocate() added to the tree's links
    std::span<LeafTriangle> triangles;  ///< written alone: may be memory that is slow to read
};

/// Whether a triangle can be hit: has a normal, and all of it is finite.
[[nodiscard]] bool hasArea(const std::array<glm::vec3, 3>& corners);

/// Bottom up: children stand behind their parents. Triangles without area get zero corners and no
/// box. On as many threads as there are cores, where that pays. \return triangles without area
uint32_t refitOnCpu(const RefitTarget& target, const Triangles& posed);

/// The surface area heuristic's expected cost of a ray that meets the tree's root: a node and a
/// triangle cost 1 each. 0 where nothing has a box.
[[nodiscard]] double costOf(const Tree& tree);

/// The same from what the node refit_sah sums up: half the root's area, then the parts.
[[nodiscard]] double costOf(float rootHalfArea, std::span<const float> parts);

}  // namespace lampyris::accel
