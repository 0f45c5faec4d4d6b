#include "photons/photon_trace.h"

#include <algorithm>

#include "photons/prefix_sum.h"
#include "photons/shaders.h"
#include "shared/scene.h"

namespace lampyris::photons {
namespace {

constexpr uint64_t kStorageRange = uint64_t{128}
                                   << 20;  // Vulkan's guaranteed maxStorageBufferRange
// [chosen] Stored hits before roulette: the first three carry most of the light and stay free of
// its noise.
constexpr uint32_t kRouletteFrom = 3;

uint32_t traceGroups(uint32_t paths) {
    return (paths + shared::TRACE_THREADS - 1) / shared::TRACE_THREADS;
}

shared::TraceParams paramsOf(const PathSplit& split, const PathBatch& batch,
                             const TraceSettings& settings) {
    return {batch.firstPath,
            batch.pathCount,
            static_cast<uint32_t>(split.ranges.size()),
            photonsPerPath(split, settings.maxBounces, settings.firstHits),
            settings.maxBounces,
            settings.firstHits ? 0u : 1u,
            settings.maxBounces + (settings.firstHits ? 0u : 1u),
            settings.roulette ? kRouletteFrom : 0xffffffffu,
            settings.seed,
            split.powerScale,
            verticesPerPath(settings.maxBounces),
            settings.turn};
}

void bindPaths(graph::ComputeNode& node, const residency::SceneHandles& scene,
               const accel::AccelHandles& accel, const PathSplit& split) {
    accel::bindTraversal(node, accel, scene);
    residency::bindEmitters(node, scene);
    node.read(shared::SLOT_LIGHTS, scene.lights)
        .storageData(shared::SLOT_PATH_RANGES, split.ranges.data(),
                     split.ranges.size() * sizeof(shared::PathRange));
}

/// Staged photons to their places in the store.
PhotonList addStore(graph::Frame& frame, graph::Buffer staged, graph::Buffer counts,
                    uint32_t pathCount, const PathSplit& split, const TraceSettings& settings,
                    graph::Buffer counters) {
    PhotonList list;
    list.pathOffsets = addPrefixSum(frame, "photon_trace", counts, pathCount);
    list.pathCount = pathCount;
    list.perPath = photonsPerPath(split, settings.maxBounces, settings.firstHits);
    list.capacity = settings.photonCapacity;
    list.powerScale = split.powerScale;
    auto store = frame.compute("photon_trace/store", shaders::photonStore);
    store.read(shared::SLOT_STAGED_PHOTONS, staged)
        .read(shared::SLOT_PATH_OFFSETS, list.pathOffsets)
        .push(shared::StoreParams{pathCount, list.perPath, settings.photonCapacity, 0});
    list.photons = store.write(shared::SLOT_PHOTONS,
                               frame.buffer("photons", {uint64_t{settings.photonCapacity} *
                                                        sizeof(shared::PackedPhoton)}));
    list.counters = store.update(shared::SLOT_COUNTERS, counters);
    store.dispatch(traceGroups(pathCount));
    return list;
}

}  // namespace

uint32_t photonsPerPath(const PathSplit& split, uint32_t maxBounces, bool firstHits) {
    return maxBounces + (split.anySurface && !firstHits ? 1u : 0u);
}

std::vector<PathBatch> batchPaths(const PathSplit& split, uint32_t maxBounces,
                                  uint32_t largestBatch) {
    const uint64_t pathBytes =
        uint64_t{photonsPerPath(split, maxBounces)} * sizeof(shared::PackedPhoton);
    const auto most = static_cast<uint32_t>(std::min<uint64_t>(
        {kStorageRange / std::max<uint64_t>(pathBytes, 1), kMaxPhotonCapacity, largestBatch}));
    std::vector<PathBatch> batches;
    // Even shares, so that the last batch is no smaller than it must be.
    const uint64_t count = (uint64_t{split.paths} + most - 1) / std::max(most, 1u);
    for (uint64_t i = 0; i < count; ++i) {
        const auto first = static_cast<uint32_t>(uint64_t{split.paths} * i / count);
        const auto end = static_cast<uint32_t>(uint64_t{split.paths} * (i + 1) / count);
        batches.push_back({first, end - first});
    }
    return batches;
}

PhotonList addPhotonTrace(graph::Frame& frame, const residency::SceneHandles& scene,
                          const accel::AccelHandles& accel, const PathSplit& split,
                          const PathBatch& batch, const TraceSettings& settings,
                          graph::Buffer counters) {
    const uint32_t groups = traceGroups(batch.pathCount);
    const shared::TraceParams params = paramsOf(split, batch, settings);
    auto trace = frame.compute("photon_trace", shaders::photonTrace);
    bindPaths(trace, scene, accel, split);
    trace.push(params);
    const uint64_t photons = uint64_t{batch.pathCount} * params.photonsPerPath;
    const graph::Buffer staged =
        trace.write(shared::SLOT_STAGED_PHOTONS,
                    frame.buffer("staged photons", {photons * sizeof(shared::PackedPhoton)}));
    const graph::Buffer counts =
        trace.write(shared::SLOT_PATH_COUNTS,
                    frame.buffer("path counts", {uint64_t{batch.pathCount} * sizeof(uint32_t)}));
    const graph::Buffer ledger = trace.write(
        shared::SLOT_LEDGER,
        frame.buffer("energy ledger", {uint64_t{groups} * shared::LEDGER_FLOATS * sizeof(float)}));
    trace.dispatch(groups);
    PhotonList list = addStore(frame, staged, counts, batch.pathCount, split, settings, counters);
    list.ledger = ledger;
    return list;
}

PhotonList addPhotonTraceKept(graph::Frame& frame, const residency::SceneHandles& scene,
                              const accel::AccelHandles& accel, const PathSplit& split,
                              const PathStoreHandles& store, const PathChoice& choice,
                              const TraceSettings& settings, graph::Buffer counters) {
    const ChosenPaths chosen =
        addPathChoice(frame, store, split, choice, settings.maxBounces, counters);
    auto trace = frame.compute("photon_trace", shaders::photonTraceKeep);
    bindPaths(trace, scene, accel, split);
    trace.read(shared::SLOT_CHOSEN_PATHS, chosen.list)
        .read(shared::SLOT_COUNTERS, chosen.counters)
        .push(paramsOf(split, {0, split.paths}, settings));
    const graph::Buffer staged = trace.update(shared::SLOT_STAGED_PHOTONS, store.staged);
    const graph::Buffer counts = trace.update(shared::SLOT_PATH_COUNTS, store.counts);
    (void)trace.update(shared::SLOT_KEPT_VERTICES, store.vertices);
    const graph::Buffer bookings = trace.update(shared::SLOT_BOOKINGS, store.bookings);
    trace.dispatchIndirect(chosen.groups);
    PhotonList list =
        addStore(frame, staged, counts, split.paths, split, settings, chosen.counters);
    list.ledger = addPathLedger(frame, bookings, split.paths);
    return list;
}

}  // namespace lampyris::photons
