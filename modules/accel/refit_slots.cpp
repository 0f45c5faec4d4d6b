#include "accel/refit_slots.h"

namespace lampyris::accel {
namespace {

/// By node: 1 above leaves alone, else one more than the higher child.
std::vector<uint32_t> heightsOf(const Tree& tree, uint32_t firstNode) {
    std::vector<uint32_t> heights(tree.nodes.size());
    const auto below = [&](uint32_t link) {
        return isLeaf(link) ? 0 : heights[linkIndex(link) - firstNode];
    };
    for (size_t i = heights.size(); i-- > 0;)
        heights[i] = 1 + std::max(below(tree.nodes[i].leftLink), below(tree.nodes[i].rightLink));
    return heights;
}

}  // namespace

RefitSlots listSlots(const Tree& tree, uint32_t firstNode) {
    RefitSlots slots;
    if (tree.nodes.empty()) return slots;
    const auto heights = heightsOf(tree, firstNode);
    const auto linkOf = [&](uint32_t texel) {
        const Node& node = tree.nodes[texel / 2];
        return texel % 2 == 0 ? node.leftLink : node.rightLink;
    };
    const auto levelOf = [&](uint32_t texel) {
        const uint32_t link = linkOf(texel);
        return isLeaf(link) ? 0 : heights[linkIndex(link) - firstNode];
    };
    // Counting sort; the root is nobody's child, so levels end below its height.
    const auto count = static_cast<uint32_t>(2 * tree.nodes.size());
    slots.levels.assign(heights[0] + 1, 0);
    for (uint32_t texel = 0; texel < count; ++texel) ++slots.levels[levelOf(texel) + 1];
    for (size_t level = 1; level < slots.levels.size(); ++level)
        slots.levels[level] += slots.levels[level - 1];
    std::vector<uint32_t> next(slots.levels);
    slots.texels.resize(count);
    for (uint32_t texel = 0; texel < count; ++texel) slots.texels[next[levelOf(texel)]++] = texel;
    return slots;
}

}  // namespace lampyris::accel
