/// \file In which order the device refits a tree: by level, so that no dispatch needs what it
/// writes.
#pragma once

#include <cstdint>
#include <vector>

#include "accel/tree.h"

namespace lampyris::accel {

/// Every child texel of a tree (2 · node, 1 more for the right), relative to the tree's first:
/// leaves first, by their size, then inner children by height.
struct RefitSlots {
    std::vector<uint32_t> texels;
    /// Where each level begins, and the end: level 0 are the leaves, level k inner nodes of which
    /// the longest way down passes k nodes.
    std::vector<uint32_t> levels;
};

/// \param firstNode what relocate() added to the tree's links
[[nodiscard]] RefitSlots listSlots(const Tree& tree, uint32_t firstNode = 0);

}  // namespace lampyris::accel
