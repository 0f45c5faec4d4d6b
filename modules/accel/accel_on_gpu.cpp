#include "accel/accel_on_gpu.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include "accel/blas.h"
#include "accel/tlas.h"
#include "core/check.h"
#include "residency/range_allocator.h"
#include "residency/resident_buffer.h"

namespace lampyris::accel {
namespace {

using residency::RangeAllocator;
using residency::ResidentBuffer;

/// A mesh's tree on the device.
struct Resident {
    BlasPlace place;
    uint64_t firstNode = 0, nodes = 0;
    uint64_t firstTriangle = 0, triangles = 0;
};

/// A tree on its way there.
struct Built {
    uint64_t version;
    Blas blas;
};

double millisecondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

}  // namespace

struct AccelOnGpu::Parts {
    explicit Parts(const residency::SceneOnGpu& scene)
        : scene(&scene),
          nodes(scene.device(), "bvh nodes", sizeof(glm::vec4)),
          triangles(scene.device(), "bvh triangles", sizeof(glm::vec4)) {}

    void forgetMissing(const scene::SceneSnapshot& snapshot);
    core::Result<void> addMissing(const scene::SceneSnapshot& snapshot);
    core::Result<void> load(residency::Loading& loading, Built& next);
    core::Result<void> rebuildTlas(const scene::SceneSnapshot& snapshot);

    const residency::SceneOnGpu* scene;
    TreeBuilder builder;
    ResidentBuffer nodes, triangles;
    RangeAllocator nodeRanges, triangleRanges;
    std::map<uint64_t, Resident> blas;  ///< by mesh version
    uint64_t firstTlasNode = 0, tlasNodes = 0;
    AccelHandles handles;  ///< without the buffers
    AccelCounts counts;
    uint64_t geometryVersion = ~uint64_t{0};
    uint64_t materialVersion = ~uint64_t{0};
};

AccelOnGpu::AccelOnGpu(const residency::SceneOnGpu& scene)
    : parts_(std::make_unique<Parts>(scene)) {}
AccelOnGpu::~AccelOnGpu() = default;
AccelOnGpu::AccelOnGpu(AccelOnGpu&&) noexcept = default;
AccelOnGpu& AccelOnGpu::operator=(AccelOnGpu&&) noexcept = default;

void AccelOnGpu::Parts::forgetMissing(const scene::SceneSnapshot& snapshot) {
    std::set<uint64_t> wanted;
    for (const auto& mesh : snapshot.meshes) wanted.insert(mesh.version);
    std::erase_if(blas, [&](const auto& item) {
        const auto& [version, resident] = item;
        if (wanted.contains(version)) return false;
        nodeRanges.give(resident.firstNode, resident.nodes);
        triangleRanges.give(resident.firstTriangle, resident.triangles);
        return true;
    });
}

core::Result<void> AccelOnGpu::Parts::addMissing(const scene::SceneSnapshot& snapshot) {
    std::vector<Built> built;
    for (const auto& mesh : snapshot.meshes) {
        if (blas.contains(mesh.version)) continue;
        TRY(Blas next, buildBlas(builder, *mesh.value));
        Resident resident;
        resident.nodes = next.tree.nodes.size();
        resident.triangles = next.triangles.size();
        resident.firstNode = nodeRanges.take(resident.nodes);
        resident.firstTriangle = triangleRanges.take(resident.triangles);
        blas.emplace(mesh.version, resident);
        built.push_back({mesh.version, std::move(next)});
    }
    counts.rebuilds = static_cast<uint32_t>(built.size());
    TRY_VOID(nodes.reserve(std::max<uint64_t>(nodeRanges.capacity(), 1) * sizeof(Node)));
    TRY_VOID(
        triangles.reserve(std::max<uint64_t>(triangleRanges.capacity(), 1) * sizeof(LeafTriangle)));
    if (built.empty()) return {};
    TRY(residency::Loading loading, residency::Loading::begin(scene->device()));
    for (Built& next : built) {
        TRY_VOID(load(loading, next));
        next.blas = {};  // the largest scenes would not fit twice
    }
    return loading.finish();
}

core::Result<void> AccelOnGpu::Parts::load(residency::Loading& loading, Built& next) {
    Resident& resident = blas.at(next.version);
    Tree& tree = next.blas.tree;
    resident.place.depth = tree.depth;
    resident.place.bounds = tree.bounds;
    resident.place.grid = tree.grid;
    if (next.blas.triangles.empty()) return {};
    relocate(tree, static_cast<uint32_t>(resident.firstNode),
             static_cast<uint32_t>(resident.firstTriangle));
    resident.place.rootLink = tree.rootLink;
    TRY_VOID(loading.write(nodes, resident.firstNode * sizeof(Node),
                           std::as_bytes(std::span(tree.nodes))));
    return loading.write(triangles, resident.firstTriangle * sizeof(LeafTriangle),
                         std::as_bytes(std::span(next.blas.triangles)));
}

core::Result<void> AccelOnGpu::Parts::rebuildTlas(const scene::SceneSnapshot& snapshot) {
    const uint64_t wanted = tlasCapacity(snapshot.instances.size());
    if (wanted > tlasNodes) {
        nodeRanges.give(firstTlasNode, tlasNodes);
        tlasNodes = 2 * wanted;
        firstTlasNode = nodeRanges.take(tlasNodes);
        TRY_VOID(nodes.reserve(nodeRanges.capacity() * sizeof(Node)));
    }
    std::vector<BlasPlace> places;
    for (const auto& mesh : snapshot.meshes) places.push_back(blas.at(mesh.version).place);
    TRY(const Tlas tlas,
        buildTlas(builder, snapshot, places, static_cast<uint32_t>(firstTlasNode)));
    CHECK(tlas.nodes.size() <= tlasNodes);
    handles.root = tlas.root;
    counts.deepest = tlas.depth;
    // The walk marks the end of both trees on its stack. In eights, so that few depths mean a new
    // pipeline.
    handles.stackEntries = (tlas.depth + 2 + 7) / 8 * 8;
    return nodes.stage(firstTlasNode * sizeof(Node), std::as_bytes(std::span(tlas.nodes)));
}

core::Result<void> AccelOnGpu::update(const scene::SceneSnapshot& snapshot) {
    Parts& p = *parts_;
    p.counts.rebuilds = 0;
    p.counts.buildMilliseconds = 0.0;
    // Materials too: whether an instance is masked stands in its record.
    if (snapshot.geometryVersion == p.geometryVersion &&
        snapshot.materialVersion == p.materialVersion)
        return {};
    const auto start = std::chrono::steady_clock::now();
    p.forgetMissing(snapshot);
    TRY_VOID(p.addMissing(snapshot));
    TRY_VOID(p.rebuildTlas(snapshot));
    p.counts.blas = static_cast<uint32_t>(p.blas.size());
    p.counts.triangles = p.triangleRanges.used();
    p.counts.buildMilliseconds = millisecondsSince(start);
    p.geometryVersion = snapshot.geometryVersion;
    p.materialVersion = snapshot.materialVersion;
    return {};
}

AccelHandles AccelOnGpu::import(graph::Frame& frame) {
    AccelHandles handles = parts_->handles;
    handles.nodes = parts_->nodes.import(frame, "tlas_upload");
    handles.triangles = parts_->triangles.import(frame, "upload bvh triangles");
    return handles;
}

const AccelCounts& AccelOnGpu::counts() const {
    return parts_->counts;
}

uint64_t AccelOnGpu::deviceBytes() const {
    return parts_->nodes.bytes() + parts_->triangles.bytes();
}

void bindTraversal(graph::ComputeNode& node, const AccelHandles& accel,
                   const residency::SceneHandles& scene) {
    residency::bindMaterials(node, scene);
    node.texels(shared::SLOT_BVH_NODES, accel.nodes, graph::Format::RGBA32Uint)
        .texels(shared::SLOT_BVH_TRIANGLES, accel.triangles, graph::Format::RGBA32Float)
        .uniformData(shared::SLOT_BVH_ROOT, accel.root)
        .specialise(shared::SPEC_BVH_STACK, accel.stackEntries)
        .specialise(shared::SPEC_BVH_MASKED, scene.anyMasked ? 1 : 0)
        .specialise(shared::SPEC_BVH_INSTANCED, accel.root.instance == shared::BVH_NOTHING ? 1 : 0);
}

}  // namespace lampyris::accel
