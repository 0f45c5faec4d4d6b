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
    std::span<const uint32_t> corners;  ///< of leafCorners()
};

/// How a tree stands after a refit.
struct RefitQuality {
    uint32_t dropped = 0;  ///< triangles without area
    double cost = 0.0;     ///< as costOf()
};

/// Whether a triangle can be hit: has a normal, and all of it is finite.
[[nodiscard]] bool hasArea(const std::array<glm::vec3, 3>& corners);

/// The vertices of the triangles in the order of the leaves, three each.
[[nodiscard]] std::vector<uint32_t> leafCorners(const Tree& tree,
                                                std::span<const uint32_t> indices);

/// Bottom up: children stand behind their parents. Triangles without area get zero corners and no
/// box. On as many threads as there are cores, where that pays.
RefitQuality refitOnCpu(const RefitTarget& target, std::span<const glm::vec3> positions);

/// The surface area heuristic's expected cost of a ray that meets the tree's root: a node and a
/// triangle cost 1 each. 0 where nothing has a box.
[[nodiscard]] double costOf(const Tree& tree);

/// The same from what the node refit_sah sums up: half the root's area, then the parts.
[[nodiscard]] double costOf(float rootHalfArea, std::span<const float> parts);

}  // namespace lampyris::accel
