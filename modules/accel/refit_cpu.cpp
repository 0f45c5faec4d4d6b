#include "accel/refit_cpu.h"

#include <bit>
#include <thread>

#include "core/check.h"
#include "shared/refit.h"

namespace lampyris::accel {
namespace {

constexpr size_t kPartNodes = shared::REFIT_COST_TEXELS / shared::BVH_NODE_TEXELS;
// Parts that are worth a thread of their own. [chosen] ~0.3 ms of work against ~0.05 ms of starting
constexpr size_t kPartsPerThread = 64;

float halfArea(const CellBox& box, const glm::vec3& cell) {
    const auto cells = [](uint32_t word) {
        return static_cast<float>((word >> 16) - (word & 0xffffu));
    };
    const glm::vec3 e = glm::vec3(cells(box.x), cells(box.y), cells(box.z)) * cell;
    return e.x * e.y + e.y * e.z + e.z * e.x;
}

float weight(uint32_t link) {
    return isLeaf(link) ? static_cast<float>(leafCount(link)) : 1.0f;
}

/// One part of a tree's cost, in the order of refit_sah.comp.
float costOfPart(const Tree& tree, size_t part) {
    const glm::vec3 cell(tree.grid.cell);
    const size_t end = std::min((part + 1) * kPartNodes, tree.nodes.size());
    float sum = 0.0f;
    for (size_t i = part * kPartNodes; i < end; ++i) {
        const Node& node = tree.nodes[i];
        sum += halfArea(node.leftBox, cell) * weight(node.leftLink);
        sum += halfArea(node.rightBox, cell) * weight(node.rightLink);
    }
    return sum;
}

double sumOf(const Tree& tree, std::span<const float> parts) {
    const CellBox root = united(tree.nodes[0].leftBox, tree.nodes[0].rightBox);
    return costOf(halfArea(root, glm::vec3(tree.grid.cell)), parts);
}

/// A run of nodes, last to first. Inner children stand behind their parents: within the run they
/// are done, but for those few that reach beyond its end, the ancestors of the node behind it.
class Run {
 public:
    Run(const RefitTarget& target, std::span<const glm::vec3> positions, std::span<float> parts,
        size_t firstPart, size_t endPart)
        : target_(target),
          positions_(positions),
          parts_(parts),
          scale_(target.tree.grid),
          firstPart_(firstPart),
          endPart_(endPart) {}

    void refit() {
        auto& nodes = target_.tree.nodes;
        const size_t end = std::min(endPart_ * kPartNodes, nodes.size());
        size_t lowestOpen = end;
        const auto isOpen = [&](uint32_t link) {
            if (isLeaf(link)) return false;
            const size_t child = link - target_.firstNode;
            return child >= end || child == lowestOpen;
        };
        for (size_t part = endPart_; part-- > firstPart_;) {
            for (size_t i = std::min((part + 1) * kPartNodes, end); i-- > part * kPartNodes;) {
                Node& node = nodes[i];
                if (isLeaf(node.leftLink)) node.leftBox = leaf(node.leftLink);
                if (isLeaf(node.rightLink)) node.rightBox = leaf(node.rightLink);
                if (end < nodes.size() && (isOpen(node.leftLink) || isOpen(node.rightLink))) {
                    open_.push_back(i);
                    lowestOpen = i;
                } else {
                    joinChildren(node);
                }
            }
            parts_[part] = costOfPart(target_.tree, part);
        }
    }

    /// What refit() had to leave; after all runs behind this one are closed.
    void close() {
        for (const size_t i : open_) joinChildren(target_.tree.nodes[i]);
        for (const size_t i : open_)
            parts_[i / kPartNodes] = costOfPart(target_.tree, i / kPartNodes);
    }
    [[nodiscard]] uint32_t dropped() const { return dropped_; }

 private:
    void joinChildren(Node& node) {
        const auto around = [&](uint32_t link) {
            const Node& child = target_.tree.nodes[link - target_.firstNode];
            return united(child.leftBox, child.rightBox);
        };
        if (!isLeaf(node.leftLink)) node.leftBox = around(node.leftLink);
        if (!isLeaf(node.rightLink)) node.rightBox = around(node.rightLink);
    }

    CellBox leaf(uint32_t link) {
        const size_t first = linkIndex(link) - target_.firstTriangle;
        math::Bounds bounds;
        for (size_t i = first; i < first + leafCount(link); ++i) {
            const uint32_t* corner = &target_.corners[3 * i];
            const uint32_t primitive = target_.tree.order[i];
            const std::array corners{positions_[corner[0]], positions_[corner[1]],
                                     positions_[corner[2]]};
            if (!hasArea(corners)) {
                target_.triangles[i] = {{}, primitive, {}, 0, {}, 0};
                ++dropped_;
                continue;
            }
            target_.triangles[i] = {corners[0], primitive, corners[1], 0, corners[2], 0};
            for (const glm::vec3& point : corners) bounds.grow(point);
        }
        return bounds.empty() ? kNoBox : scale_(bounds);
    }

    const RefitTarget& target_;
    std::span<const glm::vec3> positions_;
    std::span<float> parts_;
    CellScale scale_;
    size_t firstPart_, endPart_;
    std::vector<size_t> open_;  ///< from the last to the first
    uint32_t dropped_ = 0;
};

}  // namespace

bool hasArea(const std::array<glm::vec3, 3>& corners) {
    const glm::vec3 a = corners[1] - corners[0], b = corners[2] - corners[0];
    const glm::vec3 n = glm::abs(glm::cross(a, b));
    // A normal float above 0, by its bits: as in refit_leaves.comp.
    return std::bit_cast<uint32_t>(n.x + n.y + n.z) - 0x00800000u < 0x7f000000u;
}

std::vector<uint32_t> leafCorners(const Tree& tree, std::span<const uint32_t> indices) {
    std::vector<uint32_t> corners;
    corners.reserve(3 * tree.order.size());
    for (const uint32_t primitive : tree.order)
        for (size_t i = 0; i < 3; ++i)
            corners.push_back(indices[3 * static_cast<size_t>(primitive) + i]);
    return corners;
}

RefitQuality refitOnCpu(const RefitTarget& target, std::span<const glm::vec3> positions) {
    CHECK(target.triangles.size() == target.tree.order.size());
    CHECK(target.corners.size() == (3 * target.tree.order.size()));
    if (target.tree.nodes.empty()) return {};
    std::vector<float> parts((target.tree.nodes.size() + kPartNodes - 1) / kPartNodes);
    const size_t count = std::clamp<size_t>(parts.size() / kPartsPerThread, 1,
                                            std::max(1u, std::thread::hardware_concurrency()));
    std::vector<Run> runs;
    for (size_t t = 0; t < count; ++t)
        runs.emplace_back(target, positions, parts, parts.size() * t / count,
                          parts.size() * (t + 1) / count);
    {
        std::vector<std::jthread> others;
        for (size_t t = 1; t < count; ++t) others.emplace_back([&run = runs[t]] { run.refit(); });
        runs[0].refit();
    }
    RefitQuality quality;
    for (size_t t = count; t-- > 0;) {
        runs[t].close();
        quality.dropped += runs[t].dropped();
    }
    quality.cost = sumOf(target.tree, parts);
    return quality;
}

double costOf(const Tree& tree) {
    if (tree.nodes.empty()) return 0.0;
    std::vector<float> parts((tree.nodes.size() + kPartNodes - 1) / kPartNodes);
    for (size_t part = 0; part < parts.size(); ++part) parts[part] = costOfPart(tree, part);
    return sumOf(tree, parts);
}

double costOf(float rootHalfArea, std::span<const float> parts) {
    if (!(rootHalfArea > 0.0f)) return 0.0;
    double sum = rootHalfArea;
    for (const float part : parts) sum += part;
    return sum / rootHalfArea;
}

}  // namespace lampyris::accel
