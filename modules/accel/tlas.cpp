#include "accel/tlas.h"

#include <algorithm>
#include <array>
#include <bit>

#include "core/check.h"
#include "residency/pack_scene.h"

namespace lampyris::accel {
namespace {

using residency::Placement;

using shared::BVH_RECORD_NODES;
static_assert(sizeof(shared::GpuBvhInstance) == BVH_RECORD_NODES * sizeof(Node));

/// An instance that has triangles.
struct Candidate {
    uint32_t instance;
    Placement placement;
    const BlasPlace* blas;
    uint32_t flags;
};

std::vector<Candidate> candidates(const scene::SceneSnapshot& snapshot,
                                  std::span<const BlasPlace> blas) {
    std::vector<Candidate> result;
    for (uint32_t i = 0; i < snapshot.instances.size(); ++i) {
        const auto& instance = snapshot.instances[i];
        const BlasPlace& place = blas[i];
        const auto placement = residency::placementOf(instance.objectToWorld);
        if (place.rootLink == shared::BVH_NOTHING || !placement) continue;
        const auto& material = *snapshot.materials[instance.material].value;
        result.push_back({i, *placement, &place, residency::instanceFlags(material, *placement)});
    }
    return result;
}

void addRecord(std::vector<Node>& nodes, const Candidate& candidate) {
    const glm::mat4 rows = glm::transpose(candidate.placement.worldToObject);
    const shared::GpuBvhInstance record{rows[0],
                                        rows[1],
                                        rows[2],
                                        candidate.blas->rootLink,
                                        candidate.instance,
                                        candidate.flags,
                                        0,
                                        candidate.blas->grid};
    const auto parts = std::bit_cast<std::array<Node, BVH_RECORD_NODES>>(record);
    nodes.insert(nodes.end(), parts.begin(), parts.end());
}

/// The leaf of a tree with one candidate a leaf becomes the record of that candidate.
uint32_t toRecord(uint32_t link, const std::vector<uint32_t>& order, uint32_t firstRecord) {
    if (link == shared::BVH_NOTHING || !isLeaf(link)) return link;
    return shared::BVH_INSTANCE | (firstRecord + BVH_RECORD_NODES * order[linkIndex(link)]);
}

}  // namespace

core::Result<Tlas> buildTlas(TreeBuilder& builder, const scene::SceneSnapshot& snapshot,
                             std::span<const BlasPlace> blas, uint32_t nodeOffset) {
    CHECK(blas.size() == snapshot.instances.size());
    const auto found = candidates(snapshot, blas);
    Tlas tlas;
    for (const Candidate& candidate : found)
        tlas.depth = std::max(tlas.depth, candidate.blas->depth);
    if (found.size() == 1 && found[0].placement.identity) {
        tlas.root = {found[0].blas->rootLink, found[0].instance, found[0].flags, 0,
                     found[0].blas->grid};
        return tlas;
    }
    const BoxOf boxOf = [&found](uint32_t i, math::Bounds& box) {
        box = math::transformed(found[i].blas->bounds, found[i].placement.objectToWorld);
        return true;
    };
    TRY(Tree tree, builder.build(static_cast<uint32_t>(found.size()), 1, boxOf));
    const auto firstRecord = nodeOffset + static_cast<uint32_t>(tree.nodes.size());
    relocate(tree, nodeOffset, 0);
    tlas.depth += tree.depth;
    tlas.root.link = toRecord(tree.rootLink, tree.order, firstRecord);
    tlas.root.grid = tree.grid;
    for (Node& node : tree.nodes) {
        node.leftLink = toRecord(node.leftLink, tree.order, firstRecord);
        node.rightLink = toRecord(node.rightLink, tree.order, firstRecord);
    }
    tlas.nodes = std::move(tree.nodes);
    for (const Candidate& candidate : found) addRecord(tlas.nodes, candidate);
    return tlas;
}

}  // namespace lampyris::accel
