#include "accel/tree.h"

#include <algorithm>

namespace lampyris::accel {
namespace {

constexpr float kMostCells = 65535.0f;
// Cells on either side that boxes may be rounded and widened to.
constexpr float kBorder = 2.0f;
// A cell is at least this share of the tree's largest coordinate: a few roundings of 2⁻²⁴. [chosen]
constexpr float kLeastCell = 5e-7f;

}  // namespace

shared::GpuBvhGrid gridAround(const math::Bounds& bounds) {
    if (bounds.empty()) return {glm::vec4(0.0f), glm::vec4(1.0f)};
    const glm::vec3 reach = glm::max(glm::abs(bounds.lower), glm::abs(bounds.upper));
    const float least = std::max(kLeastCell * std::max({reach.x, reach.y, reach.z}), 1e-30f);
    const glm::vec3 cell =
        glm::max(bounds.extent() / (kMostCells - 2.0f * kBorder - 1.0f), glm::vec3(least));
    return {glm::vec4(bounds.lower - kBorder * cell, 0.0f), glm::vec4(cell, 0.0f)};
}

CellBox toCells(const shared::GpuBvhGrid& grid, const math::Bounds& box) {
    return CellScale(grid)(box);
}

math::Bounds fromCells(const shared::GpuBvhGrid& grid, const CellBox& box) {
    const glm::uvec3 words(box.x, box.y, box.z);
    const glm::vec3 offset(grid.offset), cell(grid.cell);
    return {offset + cell * glm::vec3(words & 0xffffu), offset + cell * glm::vec3(words >> 16u)};
}

uint32_t relocated(uint32_t link, uint32_t nodeOffset, uint32_t leafOffset) {
    if (link == shared::BVH_NOTHING) return link;
    return link + (isLeaf(link) ? leafOffset : nodeOffset);
}

void relocate(Tree& tree, uint32_t nodeOffset, uint32_t leafOffset) {
    tree.rootLink = relocated(tree.rootLink, nodeOffset, leafOffset);
    for (Node& node : tree.nodes) {
        node.leftLink = relocated(node.leftLink, nodeOffset, leafOffset);
        node.rightLink = relocated(node.rightLink, nodeOffset, leafOffset);
    }
}

}  // namespace lampyris::accel
