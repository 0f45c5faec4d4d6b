/// \file photon_trace: sends paths through the scene and stores what they hit; needs no camera.
///   in      BVH, materials, emitters      out   photons in the order (path, bounce), their number,
///   the ledger shader  photons/photon_trace.comp, photon_store.comp      theory  README [P1] to
///   [P4]
#pragma once

#include "accel/accel_on_gpu.h"
#include "graph/frame.h"
#include "photons/path_split.h"
#include "photons/path_store.h"
#include "residency/scene_handles.h"
#include "shared/photon.h"

namespace lampyris::photons {

struct TraceSettings {
    uint32_t maxBounces = 8;      ///< B: a path hits at most B + 1 surfaces
    bool roulette = true;         ///< past the first bounces
    uint32_t seed = 1;            ///< of this frame, or of all that differ in `turn`
    uint32_t photonCapacity = 0;  ///< of the store, in photons
    bool firstHits = false;  ///< keeps hits 0 to B − 1, direct light among them, for a final gather
                             ///< that is itself the last bounce; else hits 1 to B
    uint32_t turn = 0;  ///< frames of one seed share the ways out of the lights, and off what they
                        ///< meet first, evenly by their turns
};

/// The share of the frame's paths that is traced, binned and gathered in one go. What a shader may
/// write through a storage buffer is bounded (128 MiB guaranteed), so many photons come in several
/// batches.
struct PathBatch {
    uint32_t firstPath = 0;
    uint32_t pathCount = 0;
};

/// Photons that one path can leave: B, and without `firstHits` one more where it left an emissive
/// surface.
[[nodiscard]] uint32_t photonsPerPath(const PathSplit& split, uint32_t maxBounces,
                                      bool firstHits = false);
/// Batches that cover the split; no batch stages more than a storage buffer holds.
[[nodiscard]] std::vector<PathBatch> batchPaths(const PathSplit& split, uint32_t maxBounces,
                                                uint32_t largestBatch = 0xffffffffu);
/// The most photons that a store may hold: a dispatch of one thread each, 128 MiB, and no loop over
/// a share of them near lavapipe's 65535 turns (shaders/photon_gi/tile_test.comp).
constexpr uint32_t kMaxPhotonCapacity = 60000u * 64u;

struct PhotonList {
    graph::Buffer photons{};      ///< shared::PackedPhoton
    graph::Buffer pathOffsets{};  ///< sums before each path; [pathCount] is the photons' number,
                                  ///< dropped ones too
    graph::Buffer ledger{};       ///< shared::LEDGER_FLOATS a workgroup of TRACE_THREADS paths
    graph::Buffer counters{};     ///< shared::FrameCounters, with this batch added
    uint32_t pathCount = 0;
    uint32_t perPath = 0;  ///< photons, at most
    uint32_t capacity = 0;
    float powerScale = 1.0f;  ///< watts; unit of the photons' powers
};

/// The same for all paths at once, where those that were not chosen are as the store has them.
[[nodiscard]] PhotonList addPhotonTraceKept(graph::Frame& frame,
                                            const residency::SceneHandles& scene,
                                            const accel::AccelHandles& accel,
                                            const PathSplit& split, const PathStoreHandles& store,
                                            const PathChoice& choice, const TraceSettings& settings,
                                            graph::Buffer counters);

/// \param counters as the batch before left them
[[nodiscard]] PhotonList addPhotonTrace(graph::Frame& frame, const residency::SceneHandles& scene,
                                        const accel::AccelHandles& accel, const PathSplit& split,
                                        const PathBatch& batch, const TraceSettings& settings,
                                        graph::Buffer counters);

}  // namespace lampyris::photons
