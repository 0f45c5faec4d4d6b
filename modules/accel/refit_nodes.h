/// \file refit: new corners and boxes for trees whose vertices moved, on the device; several trees
/// in every dispatch.
///   in      nodes, triangles, slots, positions as posed, indices
///   out     nodes and triangles (what the jobs do not name stays), quality
///   shader  accel/refit_leaves.comp, refit_level.comp (a dispatch a level), refit_sah.comp
#pragma once

#include <span>
#include <vector>

#include "accel/refit_cpu.h"
#include "accel/refit_slots.h"
#include "graph/frame.h"

namespace lampyris::accel {

/// One tree. Its links on the device are absolute.
struct RefitJob {
    shared::GpuBvhGrid grid;  ///< that holds the posed triangles
    uint32_t firstNode = 0;
    uint32_t nodes = 0;
    uint32_t firstSlot = 0;        ///< of its RefitSlots in the buffer of slots
    std::vector<uint32_t> levels;  ///< RefitSlots::levels
    uint32_t firstVertex = 0;      ///< of its posed range in positions
    uint32_t firstIndex = 0;       ///< of its mesh in indices
};

struct RefitBuffers {
    graph::Buffer nodes;      ///< as AccelHandles::nodes
    graph::Buffer triangles;  ///< as AccelHandles::triangles
    graph::Buffer slots;      ///< uint32
    graph::Buffer positions;  ///< as residency::SceneHandles
    graph::Buffer indices;    ///< as residency::SceneHandles
    /// Nodes or triangles are more than a storage buffer may hold: they are written as texels,
    /// which takes longer.
    bool large = false;
};

struct Refitted {
    graph::Buffer nodes, triangles;
    graph::Buffer quality;  ///< for readQuality(); costs nothing where nobody reads it
};

/// Nodes `refit_clear`, `refit_leaves`, `refit_levels/…` and `refit_sah`. There must be a job.
[[nodiscard]] Refitted addRefit(graph::Frame& frame, const RefitBuffers& buffers,
                                std::span<const RefitJob> jobs);

/// What Refitted::quality held, a job each.
/// \param nodes  of each job's tree
[[nodiscard]] std::vector<RefitQuality> readQuality(std::span<const uint32_t> nodes,
                                                    std::span<const std::byte> bytes);

}  // namespace lampyris::accel
