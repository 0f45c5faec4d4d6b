#include "accel/tree_store.h"

#include <algorithm>

namespace lampyris::accel {

TreeStore::TreeStore(residency::Device& device)
    : nodes(device, "bvh nodes", sizeof(glm::vec4)),
      triangles(device, "bvh triangles", sizeof(glm::vec4)),
      slots(device, "bvh refit slots", sizeof(uint32_t)),
      device_(&device) {}

TreeRange TreeStore::take(uint64_t nodeCount, uint64_t triangleCount, uint64_t slotCount) {
    return {nodeRanges_.take(nodeCount),         nodeCount,
            triangleRanges_.take(triangleCount), triangleCount,
            slotRanges_.take(slotCount),         slotCount};
}

void TreeStore::give(const TreeRange& range) {
    nodeRanges_.give(range.firstNode, range.nodes);
    triangleRanges_.give(range.firstTriangle, range.triangles);
    slotRanges_.give(range.firstSlot, range.slots);
}

core::Result<void> TreeStore::reserve() {
    const auto elements = [](const auto& ranges) {
        return std::max<uint64_t>(ranges.capacity(), 1);
    };
    TRY_VOID(nodes.reserve(elements(nodeRanges_) * sizeof(Node)));
    TRY_VOID(triangles.reserve(elements(triangleRanges_) * sizeof(LeafTriangle)));
    return slots.reserve(elements(slotRanges_) * sizeof(uint32_t));
}

uint64_t TreeStore::bytes() const {
    return nodes.bytes() + triangles.bytes() + slots.bytes();
}

uint64_t TreeStore::largestBytes() const {
    return std::max(nodes.bytes(), triangles.bytes());
}

void relocate(Tree& tree, const TreeRange& range) {
    relocate(tree, static_cast<uint32_t>(range.firstNode),
             static_cast<uint32_t>(range.firstTriangle));
}

}  // namespace lampyris::accel
