#include "accel/posed_trees.h"

#include <chrono>

#include "accel/refit_cpu.h"
#include "core/check.h"

namespace lampyris::accel {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

template <typename T>
std::span<const std::byte> bytesOf(const std::vector<T>& values) {
    return std::as_bytes(std::span(values));
}

/// Room for a rebuilt tree, which may have a few nodes more, where the old one stood. [chosen]
uint64_t roomFor(uint64_t nodes) {
    return nodes + nodes / 8;
}

/// Up to here, what is seen for the first time goes up with its frame; more, as where a scene is
/// loaded, waits for the device once and keeps no host memory. [chosen]
constexpr uint64_t kMostStaged = uint64_t{4} << 20;

uint64_t bytesToSend(const PosedBlas& built) {
    return bytesOf(built.slots.texels).size() + bytesOf(built.blas.tree.nodes).size() +
           bytesOf(built.blas.triangles).size();
}

/// A measure of how large it looks: extent over distance, or extent where there is no eye.
double sizeSeen(const scene::SnapshotInstance& instance, const glm::vec3* eyeWorld) {
    const double extent = glm::length(instance.boundsWorld.extent());
    if (eyeWorld == nullptr) return extent;
    const double away = glm::distance(*eyeWorld, instance.boundsWorld.centre());
    return extent / std::max(away, 0.5 * extent + 1e-6);
}

}  // namespace

PosedTrees::PosedTrees(TreeStore& store, TreeBuilder& builder, bool onCpu,
                       const RebuildPolicy& policy)
    : store_(&store), builder_(&builder), onCpu_(onCpu), policy_(policy) {}

const BlasPlace& PosedTrees::place(ecs::Entity entity) const {
    return trees_.at(entity.bits).place;
}

core::Result<void> PosedTrees::follow(const scene::SceneSnapshot& snapshot,
                                      std::span<const residency::PosedInstance> posed,
                                      const glm::vec3* eyeWorld) {
    ++frame_;
    counts_ = {};
    Instances instances;
    for (const auto& instance : snapshot.instances)
        if (instance.pose != nullptr) instances.emplace(instance.entity.bits, &instance);
    forget(snapshot, instances);
    std::vector<Arrival> arrivals;
    TRY_VOID(collectArrivals(snapshot, instances, arrivals));
    for (const auto& where : posed) {
        const auto tree = trees_.find(where.entity.bits);
        if (tree == trees_.end()) continue;
        tree->second.firstVertex = where.firstVertex;
        tree->second.firstIndex = where.firstIndex;
    }
    TRY_VOID(store_->reserve());
    TRY_VOID(send(arrivals));
    for (auto& [entity, tree] : trees_) TRY_VOID(refit(tree, *instances.at(entity)));
    askForRebuilds(instances, eyeWorld);
    counts_.trees = static_cast<uint32_t>(trees_.size());
    sumUp();
    return {};
}

void PosedTrees::forget(const scene::SceneSnapshot& snapshot, const Instances& instances) {
    std::erase_if(trees_, [&](auto& item) {
        auto& [entity, tree] = item;
        const auto found = instances.find(entity);
        if (found != instances.end() &&
            snapshot.meshes[found->second->mesh].version == tree.meshVersion)
            return false;
        store_->give(tree.range);
        tree.forgotten.request_stop();
        if (tree.rebuild) --inFlight_;
        return true;
    });
}

bool PosedTrees::lands(const Posed& tree) const {
    if (!tree.rebuild) return false;
    if (policy_.deterministic) return frame_ >= tree.askedAt + kRebuildFrames;
    return tree.rebuild->wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

core::Result<void> PosedTrees::collectArrivals(const scene::SceneSnapshot& snapshot,
                                               const Instances& instances,
                                               std::vector<Arrival>& arrivals) {
    for (auto& [entity, tree] : trees_) {
        if (!lands(tree)) continue;
        TRY(PosedBlas built, tree.rebuild->get());
        tree.rebuild.reset();
        --inFlight_;
        settle(tree, built);
        arrivals.push_back({entity, std::move(built), false});
    }
    for (const auto& [entity, instance] : instances) {
        if (trees_.contains(entity)) continue;
        const auto& mesh = snapshot.meshes[instance->mesh];
        TRY(PosedBlas built, buildPosed(*builder_, *mesh.value, *instance->pose));
        Posed& tree = trees_[entity];
        tree.mesh = mesh.value;
        tree.meshVersion = mesh.version;
        tree.extents = scene::poseExtents(*mesh.value);
        tree.poseVersion = instance->poseVersion;
        settle(tree, built);
        arrivals.push_back({entity, std::move(built), true});
    }
    for (const Arrival& arrival : arrivals) counts_.buildMilliseconds += arrival.built.milliseconds;
    counts_.builds = static_cast<uint32_t>(arrivals.size());
    return {};
}

void PosedTrees::settle(Posed& tree, PosedBlas& built) {
    Tree& now = built.blas.tree;
    const uint64_t slots = onCpu_ ? 0 : roomFor(built.slots.texels.size());
    if (tree.range.nodes < now.nodes.size() || tree.range.triangles != now.order.size()) {
        store_->give(tree.range);
        tree.range = store_->take(roomFor(now.nodes.size()), now.order.size(), slots);
    }
    relocate(now, tree.range);
    tree.place = {now.rootLink, now.depth, now.bounds, now.grid};
    tree.levels = std::move(built.slots.levels);
    tree.nodes = static_cast<uint32_t>(now.nodes.size());
    tree.builtCost = tree.cost = built.cost;
    tree.dropped = built.blas.dropped;
}

core::Result<void> PosedTrees::send(std::vector<Arrival>& arrivals) {
    uint64_t firstBytes = 0;
    for (const Arrival& arrival : arrivals)
        if (arrival.first) firstBytes += bytesToSend(arrival.built);
    std::optional<residency::Loading> loading;
    if (firstBytes > kMostStaged) {
        TRY(residency::Loading begun, residency::Loading::begin(store_->device()));
        loading.emplace(std::move(begun));
    }
    for (Arrival& arrival : arrivals) {
        Posed& tree = trees_.at(arrival.entity);
        Blas& blas = arrival.built.blas;
        const auto write = [&](residency::ResidentBuffer& target, uint64_t offset,
                               std::span<const std::byte> bytes) {
            return arrival.first && loading ? loading->write(target, offset, bytes)
                                            : target.stage(offset, bytes);
        };
        if (!onCpu_)
            TRY_VOID(write(store_->slots, tree.range.firstSlot * sizeof(uint32_t),
                           bytesOf(arrival.built.slots.texels)));
        if (arrival.first || !onCpu_) {
            TRY_VOID(write(store_->nodes, tree.range.firstNode * sizeof(Node),
                           bytesOf(blas.tree.nodes)));
            TRY_VOID(write(store_->triangles, tree.range.firstTriangle * sizeof(LeafTriangle),
                           bytesOf(blas.triangles)));
        }
        if (onCpu_) {
            tree.corners = leafCorners(blas.tree, tree.mesh->indices);
            tree.tree = std::move(blas.tree);
        }
        if (!arrival.first) tree.poseVersion = ~uint64_t{0};  // its pose is some frames old
    }
    return loading ? loading->finish() : core::Result<void>{};
}

core::Result<void> PosedTrees::refit(Posed& tree, const scene::SnapshotInstance& instance) {
    if (tree.poseVersion == instance.poseVersion) return {};
    tree.poseVersion = instance.poseVersion;
    if (tree.nodes == 0) return {};
    ++counts_.refits;
    tree.place.bounds = treeBounds(tree.extents, *instance.pose);
    tree.place.grid = gridAround(tree.place.bounds);
    if (onCpu_) return refitNow(tree, *instance.pose);
    tree.refitOnDevice = true;
    return {};
}

core::Result<void> PosedTrees::refitNow(Posed& tree, const scene::Pose& pose) {
    const auto before = Clock::now();
    const auto positions = scene::posedVertices(*tree.mesh, pose).positions;
    counts_.posingMilliseconds += millisecondsSince(before);
    const uint64_t bytes = tree.range.triangles * sizeof(LeafTriangle);
    TRY(const std::span<std::byte> room,
        store_->triangles.stageRoom(tree.range.firstTriangle * sizeof(LeafTriangle), bytes));
    const auto start = Clock::now();
    tree.tree.grid = tree.place.grid;
    const std::span triangles(reinterpret_cast<LeafTriangle*>(room.data()), tree.range.triangles);
    const RefitQuality quality =
        refitOnCpu({tree.tree, static_cast<uint32_t>(tree.range.firstNode),
                    static_cast<uint32_t>(tree.range.firstTriangle), triangles, tree.corners},
                   positions);
    tree.dropped = quality.dropped;
    tree.cost = quality.cost;
    counts_.refitMilliseconds += millisecondsSince(start);
    return store_->nodes.stage(tree.range.firstNode * sizeof(Node), bytesOf(tree.tree.nodes));
}

std::vector<RefitJob> PosedTrees::takeJobs() {
    std::vector<RefitJob> jobs;
    asked_.clear();
    for (auto& [entity, tree] : trees_) {
        if (!tree.refitOnDevice) continue;
        tree.refitOnDevice = false;
        jobs.push_back({tree.place.grid, static_cast<uint32_t>(tree.range.firstNode), tree.nodes,
                        static_cast<uint32_t>(tree.range.firstSlot), tree.levels, tree.firstVertex,
                        tree.firstIndex});
        asked_.push_back({entity, tree.nodes});
    }
    return jobs;
}

void PosedTrees::learn(std::span<const std::byte> quality) {
    std::vector<uint32_t> nodes;
    for (const Asked& job : asked_) nodes.push_back(job.nodes);
    const auto known = readQuality(nodes, quality);
    for (size_t i = 0; i < known.size(); ++i) {
        const auto tree = trees_.find(asked_[i].entity);
        if (tree == trees_.end()) continue;
        tree->second.dropped = known[i].dropped;
        tree->second.cost = known[i].cost;
    }
    sumUp();
}

void PosedTrees::sumUp() {
    counts_.dropped = 0;
    counts_.costRatioMax = 1.0;
    wanting_ = false;
    for (const auto& [entity, tree] : trees_) {
        counts_.dropped += tree.dropped;
        counts_.costRatioMax = std::max(counts_.costRatioMax, tree.ratio());
        if (!tree.rebuild && tree.ratio() > policy_.costRatio) wanting_ = true;
    }
}

void PosedTrees::askForRebuilds(const Instances& instances, const glm::vec3* eyeWorld) {
    struct Candidate {
        double urgency;
        uint32_t entity;
    };
    std::vector<Candidate> candidates;
    uint64_t inFlight = 0;
    for (const auto& [entity, tree] : trees_) {
        if (tree.rebuild) inFlight += tree.range.triangles;
        if (tree.rebuild || tree.ratio() <= policy_.costRatio) continue;
        candidates.push_back({tree.ratio() * sizeSeen(*instances.at(entity), eyeWorld), entity});
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const auto& a, const auto& b) { return a.urgency > b.urgency; });
    for (const Candidate& candidate : candidates) {
        Posed& tree = trees_.at(candidate.entity);
        // Nobody smaller goes first: what is large would wait for ever.
        if (inFlight > 0 && inFlight + tree.range.triangles > policy_.trianglesInFlight) break;
        inFlight += tree.range.triangles;
        tree.rebuild = worker_.ask(tree.mesh, instances.at(candidate.entity)->pose,
                                   tree.forgotten.get_token());
        tree.askedAt = frame_;
        ++inFlight_;
    }
}

}  // namespace lampyris::accel
