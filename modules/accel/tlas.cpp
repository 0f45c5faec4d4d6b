#include "accel/tlas.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "core/check.h"
#include "residency/pack_scene.h"

namespace lampyris::accel {
namespace {

using residency::Placement;

/// What stands in an instance's place among the nodes: see shared/bvh.h.
struct Record {
    glm::vec4 worldToObject0, worldToObject1, worldToObject2;
    uint32_t rootLink, instance, flags, pad0;
};
static_assert(sizeof(Record) == sizeof(Node));

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
        const BlasPlace& place = blas[instance.mesh];
        const auto placement = residency::placementOf(instance.objectToWorld);
        if (place.rootLink == shared::BVH_NOTHING || !placement) continue;
        const auto& material = *snapshot.materials[instance.material].value;
        result.push_back({i, *placement, &place, residency::instanceFlags(material, *placement)});
    }
    return result;
}

Node recordOf(const Candidate& candidate) {
    const glm::mat4& m = candidate.placement.worldToObject;
    const glm::mat4 rows = glm::transpose(m);
    const Record record{
        rows[0],         rows[1], rows[2], candidate.blas->rootLink, candidate.instance,
        candidate.flags, 0};
    return std::bit_cast<Node>(record);
}

/// The leaf of a tree with one candidate a leaf becomes the record of that candidate.
uint32_t toRecord(uint32_t link, const std::vector<uint32_t>& order, uint32_t firstRecord) {
    if (link == shared::BVH_NOTHING || !isLeaf(link)) return link;
    return shared::BVH_INSTANCE | (firstRecord + order[linkIndex(link)]);
}

}  // namespace

core::Result<Tlas> buildTlas(TreeBuilder& builder, const scene::SceneSnapshot& snapshot,
                             std::span<const BlasPlace> blas, uint32_t nodeOffset) {
    CHECK(blas.size() == snapshot.meshes.size());
    const auto found = candidates(snapshot, blas);
    Tlas tlas;
    for (const Candidate& candidate : found)
        tlas.depth = std::max(tlas.depth, candidate.blas->depth);
    if (found.size() == 1 && found[0].placement.identity) {
        tlas.root = {found[0].blas->rootLink, found[0].instance, found[0].flags, 0};
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
    for (Node& node : tree.nodes) {
        node.leftLink = toRecord(node.leftLink, tree.order, firstRecord);
        node.rightLink = toRecord(node.rightLink, tree.order, firstRecord);
    }
    tlas.nodes = std::move(tree.nodes);
    for (const Candidate& candidate : found) tlas.nodes.push_back(recordOf(candidate));
    return tlas;
}

}  // namespace lampyris::accel
