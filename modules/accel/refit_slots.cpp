#include "accel/refit_slots.h"

namespace lampyris::accel {
namespace {

constexpr uint32_t kLeafSizes = 4;  // triangles of the largest leaf

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
    // Leaves by their size too: lanes of a SIMD device then loop equally long.
    const auto keyOf = [&](uint32_t texel) {
        const uint32_t link = linkOf(texel);
        return isLeaf(link) ? leafCount(link) - 1
                            : kLeafSizes - 1 + heights[linkIndex(link) - firstNode];
    };
    // Counting sort; the root is nobody's child, so levels end below its height.
    const auto count = static_cast<uint32_t>(2 * tree.nodes.size());
    std::vector<uint32_t> next(heights[0] + kLeafSizes, 0);
    for (uint32_t texel = 0; texel < count; ++texel) ++next[keyOf(texel) + 1];
    for (size_t key = 1; key < next.size(); ++key) next[key] += next[key - 1];
    slots.levels.assign(next.begin() + kLeafSizes - 1, next.end());
    slots.levels[0] = 0;
    slots.texels.resize(count);
    for (uint32_t texel = 0; texel < count; ++texel) slots.texels[next[keyOf(texel)]++] = texel;
    return slots;
}

}  // namespace lampyris::accel
