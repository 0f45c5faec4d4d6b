/// \file irradiance grid: what photons bring to cells of space, to be looked up anywhere.
///   in      photons, BVH              out   irradiance by cell, for lib/grid_look_up.glsl
///   shader  photons/irradiance_grid_*.comp      theory  README [I1] to [I3]
///
/// Needs no camera and nothing that was computed before: which cells there are, and how much
/// surface each has, is found anew every frame, so that geometry may move.
#pragma once

#include "photons/photon_trace.h"
#include "shared/irradiance_grid.h"

namespace lampyris::photons {

struct GridSettings {
    float cellMetres = 0.5f;    ///< a cell's edge
    uint32_t slots = 1u << 16;  ///< of the hash table, a power of two
    uint32_t columns = 16;      ///< rays that measure a cell's surface
    uint32_t seed = 1;
    uint32_t turn = 0;  ///< of this frame: moves the cells, so that frames differ in where they are
                        ///< coarse
};

/// The grid while it is being filled, batch by batch.
struct GridCells {
    graph::Buffer table{}, cells{};
    graph::Buffer counters{};     ///< shared::FrameCounters
    graph::Buffer photonSlots{};  ///< of the last batch: where each photon went
    shared::GridParams params{};
};

struct IrradianceGrid {
    graph::Buffer lookUp{};   ///< texels RGBA32Uint, one a slot
    graph::Buffer lookUps{};  ///< zeros: for counting how often each slot is looked up
    graph::Buffer table{};    ///< sums and areas that it was made from
    shared::GridParams params{};
};

/// Cells that a table of that many slots takes: so few that none lies GRID_MOST_PROBES slots off.
[[nodiscard]] constexpr uint32_t cellsIn(uint32_t slots) {
    return slots / 4;
}
/// The largest table: 128 MiB, Vulkan's guaranteed storage-buffer range.
constexpr uint32_t kMostGridSlots = 1u << 22;

/// \param counters shared::FrameCounters
[[nodiscard]] GridCells beginGrid(graph::Frame& frame, const GridSettings& settings,
                                  float powerScale, graph::Buffer counters);

/// \param photons of paths traced with TraceSettings::firstHits, so that direct light is in them
[[nodiscard]] GridCells addToGrid(graph::Frame& frame, GridCells cells, const PhotonList& photons,
                                  const residency::SceneHandles& scene,
                                  const accel::AccelHandles& accel);

[[nodiscard]] IrradianceGrid finishGrid(graph::Frame& frame, const GridCells& cells,
                                        const residency::SceneHandles& scene,
                                        const accel::AccelHandles& accel);

/// Binds what lib/grid_look_up.glsl reads, the BVH included.
void bindGrid(graph::ComputeNode& node, const IrradianceGrid& grid,
              const residency::SceneHandles& scene, const accel::AccelHandles& accel);

}  // namespace lampyris::photons
