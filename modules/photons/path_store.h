/// \file path store: paths that go on from frame to frame, and which of them are traced again.
///   in      what changed     out   a list of paths to trace
///   shader  photons/path_choice.comp, path_groups.comp, path_ledger.comp     theory  README [K1]
///
/// Selective photon tracing after Dmitriev et al. 2002: a path can have changed only where its
/// emitter did, or where one of its segments meets a box in which geometry changed.
#pragma once

#include <span>
#include <vector>

#include "math/bounds.h"
#include "photons/path_split.h"
#include "residency/resident_buffer.h"

namespace lampyris::photons {

/// Which paths of a frame are traced again.
struct PathChoice {
    bool all = true;                    ///< nothing is kept
    std::vector<math::Bounds> boxes;    ///< world; geometry changed in them
    std::vector<uint32_t> rangesAgain;  ///< a word a range of the split, not 0: its emitter changed
    uint32_t turns = 0;  ///< path p is drawn anew in every `turns`-th frame; 0: never
    uint32_t turn = 0;   ///< of this frame
};

/// The store in one graph::Frame.
struct PathStoreHandles {
    graph::Buffer staged, counts, vertices, bookings;
};

/// What the last frame's paths left, on the device.
class PathStore {
 public:
    /// \param device must outlive this.
    explicit PathStore(residency::Device& device);

    /// Makes room. What was there is worth nothing where paths or bounces differ from the last
    /// call. Errors: a limit or memory of the device.
    core::Result<void> reserve(uint32_t paths, uint32_t photonsPerPath, uint32_t maxBounces);
    [[nodiscard]] PathStoreHandles import(graph::Frame& frame);
    [[nodiscard]] uint64_t bytes() const;

 private:
    residency::ResidentBuffer staged_, counts_, vertices_, bookings_;
};

/// Vertices that a path can have: its start, hits, and where it left the scene.
[[nodiscard]] inline uint32_t verticesPerPath(uint32_t maxBounces) {
    return maxBounces + 3;
}

/// Whether so many paths go into one store: a storage buffer holds 128 MiB wherever Vulkan runs.
[[nodiscard]] bool fitsStore(uint32_t paths, uint32_t maxBounces);

/// The paths to trace, and an indirect dispatch over them.
struct ChosenPaths {
    graph::Buffer list, groups, counters;
};

[[nodiscard]] ChosenPaths addPathChoice(graph::Frame& frame, const PathStoreHandles& store,
                                        const PathSplit& split, const PathChoice& choice,
                                        uint32_t maxBounces, graph::Buffer counters);

/// Sums the paths' bookings, LEDGER_FLOATS for each TRACE_THREADS paths, in their order.
[[nodiscard]] graph::Buffer addPathLedger(graph::Frame& frame, graph::Buffer bookings,
                                          uint32_t paths);

}  // namespace lampyris::photons
