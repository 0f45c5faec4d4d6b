#include "accel/refit_cpu.h"

#include <bit>
#include <thread>

#include "core/check.h"
#include "shared/refit.h"

namespace lampyris::accel {
namespace {

// Nodes that are worth a thread of their own. [chosen] ~0.3 ms of work against ~0.05 ms of starting
constexpr size_t kNodesPerThread = 4096;

class Refit {
 public:
    Refit(const RefitTarget& target, const Triangles& posed)
        : target_(target), posed_(posed), scale_(target.tree.grid) {}

    /// The leaves below nodes first to end. \return triangles without area
    uint32_t leaves(size_t first, size_t end) {
        uint32_t dropped = 0;
        for (size_t i = first; i < end; ++i) {
            Node& node = target_.tree.nodes[i];
            if (isLeaf(node.leftLink)) node.leftBox = leaf(node.leftLink, dropped);
            if (isLeaf(node.rightLink)) node.rightBox = leaf(node.rightLink, dropped);
        }
        return dropped;
    }

    void innerNodes() {
        auto& nodes = target_.tree.nodes;
        const auto around = [&](uint32_t link) {
            const Node& child = nodes[link - target_.firstNode];
            return united(child.leftBox, child.rightBox);
        };
        for (size_t i = nodes.size(); i-- > 0;) {
            Node& node = nodes[i];
            if (!isLeaf(node.leftLink)) node.leftBox = around(node.leftLink);
            if (!isLeaf(node.rightLink)) node.rightBox = around(node.rightLink);
        }
    }

 private:
    CellBox leaf(uint32_t link, uint32_t& dropped) {
        const uint32_t first = linkIndex(link) - target_.firstTriangle;
        math::Bounds bounds;
        for (uint32_t i = first; i < first + leafCount(link); ++i) {
            const uint32_t primitive = target_.tree.order[i];
            const auto corners = posed_.corners(primitive);
            if (!hasArea(corners)) {
                target_.triangles[i] = {{}, primitive, {}, 0, {}, 0};
                ++dropped;
                continue;
            }
            target_.triangles[i] = {corners[0], primitive, corners[1], 0, corners[2], 0};
            for (const glm::vec3& corner : corners) bounds.grow(corner);
        }
        return bounds.empty() ? kNoBox : scale_(bounds);
    }

    const RefitTarget& target_;
    const Triangles& posed_;
    const CellScale scale_;
};

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

}  // namespace

bool hasArea(const std::array<glm::vec3, 3>& corners) {
    const glm::vec3 a = corners[1] - corners[0], b = corners[2] - corners[0];
    const glm::vec3 n = glm::abs(glm::cross(a, b));
    // A normal float above 0, by its bits: as in refit_leaves.comp.
    return std::bit_cast<uint32_t>(n.x + n.y + n.z) - 0x00800000u < 0x7f000000u;
}

uint32_t refitOnCpu(const RefitTarget& target, const Triangles& posed) {
    CHECK(target.triangles.size() == target.tree.order.size());
    Refit refit(target, posed);
    const size_t nodes = target.tree.nodes.size();
    const size_t threads = std::clamp<size_t>(nodes / kNodesPerThread, 1,
                                              std::max(1u, std::thread::hardware_concurrency()));
    std::vector<uint32_t> dropped(threads, 0);
    {
        std::vector<std::jthread> others;
        const auto share = [&](size_t t) {
            dropped[t] = refit.leaves(nodes * t / threads, nodes * (t + 1) / threads);
        };
        for (size_t t = 1; t < threads; ++t) others.emplace_back(share, t);
        share(0);
    }
    refit.innerNodes();
    uint32_t sum = 0;
    for (const uint32_t count : dropped) sum += count;
    return sum;
}

double costOf(const Tree& tree) {
    if (tree.nodes.empty()) return 0.0;
    const glm::vec3 cell(tree.grid.cell);
    std::vector<float> parts;
    constexpr size_t kNodes = shared::REFIT_COST_TEXELS / shared::BVH_NODE_TEXELS;
    for (size_t i = 0; i < tree.nodes.size(); ++i) {
        if (i % kNodes == 0) parts.push_back(0.0f);
        const Node& node = tree.nodes[i];
        parts.back() += halfArea(node.leftBox, cell) * weight(node.leftLink);
        parts.back() += halfArea(node.rightBox, cell) * weight(node.rightLink);
    }
    const CellBox root = united(tree.nodes[0].leftBox, tree.nodes[0].rightBox);
    return costOf(halfArea(root, cell), parts);
}

double costOf(float rootHalfArea, std::span<const float> parts) {
    if (!(rootHalfArea > 0.0f)) return 0.0;
    double sum = rootHalfArea;
    for (const float part : parts) sum += part;
    return sum / rootHalfArea;
}

}  // namespace lampyris::accel
