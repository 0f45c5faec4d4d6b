#include "accel/accel_on_gpu.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include "accel/posed_trees.h"
#include "core/check.h"

namespace lampyris::accel {
namespace {

// [measured] Another size makes six pipelines anew, on lavapipe a third of a second and 31 MiB that
// stay; a larger stack costs no time there.
constexpr uint32_t kStackStep = 64;

/// The tree of a mesh at rest.
struct Resident {
    BlasPlace place;
    TreeRange range;
    uint32_t dropped = 0;
};

/// A tree on its way to the device.
struct Built {
    uint64_t version;
    Blas blas;
};

double millisecondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

/// Versions of the meshes that some instance has at rest, or no instance at all.
std::set<uint64_t> meshesAtRest(const scene::SceneSnapshot& snapshot) {
    std::vector<bool> posed(snapshot.meshes.size(), false), rest(snapshot.meshes.size(), false);
    for (const auto& instance : snapshot.instances)
        (instance.pose != nullptr ? posed : rest)[instance.mesh] = true;
    std::set<uint64_t> versions;
    for (size_t i = 0; i < snapshot.meshes.size(); ++i)
        if (rest[i] || !posed[i]) versions.insert(snapshot.meshes[i].version);
    return versions;
}

}  // namespace

struct AccelOnGpu::Parts {
    Parts(const residency::SceneOnGpu& scene, const AccelSettings& settings)
        : scene(&scene),
          store(scene.device()),
          posed(store, builder, refitsOnCpu(scene.device().info().kind, settings.refit),
                settings.rebuild) {}

    core::Result<void> followMeshes(const scene::SceneSnapshot& snapshot);
    core::Result<void> load(residency::Loading& loading, Built& next);
    core::Result<void> rebuildTlas(const scene::SceneSnapshot& snapshot);
    void count();

    const residency::SceneOnGpu* scene;
    TreeBuilder builder;
    TreeStore store;
    std::map<uint64_t, Resident> blas;  ///< of meshes at rest, by version
    PosedTrees posed;
    TreeRange tlas;
    AccelHandles handles;  ///< without the buffers
    AccelCounts counts;
    uint64_t geometryVersion = ~uint64_t{0};
    uint64_t materialVersion = ~uint64_t{0};
};

AccelOnGpu::AccelOnGpu(const residency::SceneOnGpu& scene, const AccelSettings& settings)
    : parts_(std::make_unique<Parts>(scene, settings)) {}
AccelOnGpu::~AccelOnGpu() = default;
AccelOnGpu::AccelOnGpu(AccelOnGpu&&) noexcept = default;
AccelOnGpu& AccelOnGpu::operator=(AccelOnGpu&&) noexcept = default;

core::Result<void> AccelOnGpu::Parts::followMeshes(const scene::SceneSnapshot& snapshot) {
    const auto wanted = meshesAtRest(snapshot);
    std::erase_if(blas, [&](const auto& item) {
        const auto& [version, resident] = item;
        if (wanted.contains(version)) return false;
        store.give(resident.range);
        return true;
    });
    const auto start = std::chrono::steady_clock::now();
    std::vector<Built> built;
    for (const auto& mesh : snapshot.meshes) {
        if (blas.contains(mesh.version) || !wanted.contains(mesh.version)) continue;
        TRY(Blas next, buildBlas(builder, *mesh.value));
        blas[mesh.version].range = store.take(next.tree.nodes.size(), next.triangles.size(), 0);
        built.push_back({mesh.version, std::move(next)});
    }
    TRY_VOID(store.reserve());
    if (built.empty()) return {};
    counts.rebuilds = static_cast<uint32_t>(built.size());
    counts.rebuildMilliseconds = millisecondsSince(start);
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
    relocate(tree, resident.range);
    resident.place = {tree.rootLink, tree.depth, tree.bounds, tree.grid};
    resident.dropped = next.blas.dropped;
    TRY_VOID(loading.write(store.nodes, resident.range.firstNode * sizeof(Node),
                           std::as_bytes(std::span(tree.nodes))));
    return loading.write(store.triangles, resident.range.firstTriangle * sizeof(LeafTriangle),
                         std::as_bytes(std::span(next.blas.triangles)));
}

core::Result<void> AccelOnGpu::Parts::rebuildTlas(const scene::SceneSnapshot& snapshot) {
    const uint64_t wanted = tlasCapacity(snapshot.instances.size());
    if (wanted > tlas.nodes) {
        store.give(tlas);
        tlas = store.take(2 * wanted, 0, 0);
        TRY_VOID(store.reserve());
    }
    std::vector<BlasPlace> places;
    for (const auto& instance : snapshot.instances)
        places.push_back(instance.pose != nullptr
                             ? posed.place(instance.entity)
                             : blas.at(snapshot.meshes[instance.mesh].version).place);
    TRY(const Tlas built,
        buildTlas(builder, snapshot, places, static_cast<uint32_t>(tlas.firstNode)));
    CHECK(built.nodes.size() <= tlas.nodes);
    handles.root = built.root;
    counts.deepest = built.depth;
    // The walk marks the end of both trees on its stack.
    const uint32_t entries = built.depth + 2;
    handles.stackEntries =
        std::max(handles.stackEntries, (entries + kStackStep - 1) / kStackStep * kStackStep);
    return store.nodes.stage(tlas.firstNode * sizeof(Node), std::as_bytes(std::span(built.nodes)));
}

void AccelOnGpu::Parts::count() {
    const PosedCounts& moving = posed.counts();
    counts.blas = static_cast<uint32_t>(blas.size()) + moving.trees;
    counts.triangles = store.triangleCount();
    counts.refits = moving.refits;
    counts.rebuilds += moving.builds;
    counts.refitMilliseconds = moving.refitMilliseconds;
    counts.rebuildMilliseconds += moving.buildMilliseconds;
}

core::Result<void> AccelOnGpu::update(const scene::SceneSnapshot& snapshot,
                                      const glm::vec3* eyeWorld) {
    Parts& p = *parts_;
    p.counts.refits = p.counts.rebuilds = 0;
    p.counts.refitMilliseconds = p.counts.rebuildMilliseconds = p.counts.buildMilliseconds = 0.0;
    // Materials too: whether an instance is masked stands in its record.
    if (snapshot.geometryVersion == p.geometryVersion &&
        snapshot.materialVersion == p.materialVersion && !p.posed.busy())
        return {};
    const auto start = std::chrono::steady_clock::now();
    TRY_VOID(p.followMeshes(snapshot));
    TRY_VOID(p.posed.follow(snapshot, p.scene->posed(), eyeWorld));
    TRY_VOID(p.rebuildTlas(snapshot));
    p.count();
    p.counts.buildMilliseconds = millisecondsSince(start);
    p.geometryVersion = snapshot.geometryVersion;
    p.materialVersion = snapshot.materialVersion;
    return {};
}

AccelHandles AccelOnGpu::import(graph::Frame& frame, const residency::SceneHandles& scene) {
    Parts& p = *parts_;
    AccelHandles handles = p.handles;
    handles.nodes = p.store.nodes.import(frame, "tlas_upload");
    handles.triangles = p.store.triangles.import(frame, "upload bvh triangles");
    const graph::Buffer slots = p.store.slots.import(frame, "upload bvh refit slots");
    const auto jobs = p.posed.takeJobs();
    if (jobs.empty()) return handles;
    const Refitted refitted =
        addRefit(frame,
                 {handles.nodes, handles.triangles, slots, scene.positions, scene.indices,
                  p.store.largestBytes() > p.scene->device().limits().core.maxStorageBufferRange},
                 jobs);
    handles.nodes = refitted.nodes;
    handles.triangles = refitted.triangles;
    handles.quality = refitted.quality;
    return handles;
}

void AccelOnGpu::learn(std::span<const std::byte> quality) {
    parts_->posed.learn(quality);
}

const AccelCounts& AccelOnGpu::counts() const {
    AccelCounts& counts = parts_->counts;
    counts.sahRatioMax = parts_->posed.counts().costRatioMax;
    counts.dropped = parts_->posed.counts().dropped;
    for (const auto& [version, resident] : parts_->blas) counts.dropped += resident.dropped;
    return counts;
}

uint64_t AccelOnGpu::deviceBytes() const {
    return parts_->store.bytes();
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
