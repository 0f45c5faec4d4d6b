#include "photons/irradiance_grid.h"

#include "core/check.h"
#include "photons/shaders.h"

namespace lampyris::photons {
namespace {

/// A number in [0, 1) for each of a frame's three axes (xorshift-multiply; Wellons's lowbias32).
float fraction(uint32_t x) {
    x ^= x >> 16u;
    x *= 0x7feb352du;
    x ^= x >> 15u;
    x *= 0x846ca68bu;
    x ^= x >> 16u;
    return static_cast<float>(x >> 8u) * 0x1p-24f;
}

/// Goes evenly over the unit cube, turn by turn (Roberts 2018, R3), from a place that is the
/// seed's.
glm::vec3 offsetOf(const GridSettings& settings) {
    // Multiples of 2^32 over the root of x^4 = x + 1, 1.2207..., and over its powers.
    constexpr glm::uvec3 kSteps{3518319155u, 2882110345u, 2360945575u};
    const uint32_t first = 3 * settings.seed;
    const glm::uvec3 moved = settings.turn * kSteps;
    return glm::fract(glm::vec3(fraction(first), fraction(first + 1), fraction(first + 2)) +
                      glm::vec3(moved >> 8u) * 0x1p-24f);
}

struct Groups {
    graph::Buffer buffer;
    uint64_t columns = 0, cells = 3 * sizeof(uint32_t);  ///< offsets
};

Groups addGroups(graph::Frame& frame, const GridCells& cells) {
    auto node = frame.compute("irradiance_grid/groups", shaders::irradianceGridGroups);
    node.uniformData(shared::SLOT_GRID_PARAMS, cells.params)
        .read(shared::SLOT_GRID_COUNTERS, cells.counters);
    Groups groups;
    groups.buffer =
        node.write(shared::SLOT_GRID_GROUPS, frame.buffer("grid groups", {6 * sizeof(uint32_t)}));
    node.dispatch(1);
    return groups;
}

graph::Buffer addAreas(graph::Frame& frame, const GridCells& cells, const Groups& groups,
                       const residency::SceneHandles& scene, const accel::AccelHandles& accel) {
    auto node = frame.compute("irradiance_grid/area", shaders::irradianceGridArea);
    accel::bindTraversal(node, accel, scene);
    node.uniformData(shared::SLOT_GRID_PARAMS, cells.params)
        .read(shared::SLOT_GRID_CELLS, cells.cells)
        .read(shared::SLOT_GRID_COUNTERS, cells.counters);
    const graph::Buffer table = node.update(shared::SLOT_GRID_TABLE, cells.table);
    node.dispatchIndirect(groups.buffer, groups.columns);
    return table;
}

}  // namespace

GridCells beginGrid(graph::Frame& frame, const GridSettings& settings, float powerScale,
                    graph::Buffer counters) {
    CHECK(settings.columns > 0u);
    const uint64_t tableBytes =
        uint64_t{settings.slots} * shared::GRID_SLOT_WORDS * sizeof(uint32_t);
    const uint32_t capacity = cellsIn(settings.slots);
    GridCells cells;
    cells.counters = counters;
    cells.params.offsetCell = glm::vec4(offsetOf(settings), settings.cellMetres);
    cells.params.slotMask = settings.slots - 1;
    cells.params.cellCapacity = capacity;
    cells.params.columns = settings.columns;
    cells.params.seed = settings.seed + settings.turn * 0x85EBCA77u;
    cells.params.powerScale = powerScale;
    auto clear = frame.transfer("irradiance_grid/clear");
    cells.table = clear.fill(frame.buffer("grid table", {tableBytes}), 0);
    cells.cells =
        clear.fill(frame.buffer("grid cells", {uint64_t{capacity} * sizeof(shared::GridCell)}), 0);
    return cells;
}

GridCells addToGrid(graph::Frame& frame, GridCells cells, const PhotonList& photons,
                    const residency::SceneHandles& scene, const accel::AccelHandles& accel) {
    cells.params.pathCount = photons.pathCount;
    cells.params.photonCapacity = photons.capacity;
    auto node = frame.compute("irradiance_grid/insert", shaders::irradianceGridInsert);
    accel::bindTraversal(node, accel, scene);
    node.uniformData(shared::SLOT_GRID_PARAMS, cells.params)
        .texels(shared::SLOT_GRID_PHOTONS, photons.photons, graph::Format::RGBA32Uint)
        .read(shared::SLOT_GRID_PHOTON_TOTAL, photons.pathOffsets);
    cells.table = node.update(shared::SLOT_GRID_TABLE, cells.table);
    cells.cells = node.update(shared::SLOT_GRID_CELLS, cells.cells);
    cells.counters = node.update(shared::SLOT_GRID_COUNTERS, photons.counters);
    cells.photonSlots =
        node.write(shared::SLOT_GRID_PHOTON_SLOTS,
                   frame.buffer("photons' slots", {uint64_t{photons.capacity} * sizeof(uint32_t)}));
    node.dispatch((photons.capacity + 63) / 64);
    return cells;
}

IrradianceGrid finishGrid(graph::Frame& frame, const GridCells& cells,
                          const residency::SceneHandles& scene, const accel::AccelHandles& accel) {
    const Groups groups = addGroups(frame, cells);
    const graph::Buffer table = addAreas(frame, cells, groups, scene, accel);

    const uint64_t slots = uint64_t{cells.params.slotMask} + 1;
    auto clear = frame.transfer("irradiance_grid/clear_look_up");
    IrradianceGrid grid{
        clear.fill(frame.buffer("grid look-up", {slots * sizeof(shared::uvec4)}), 0),
        clear.fill(frame.buffer("grid look-ups counted", {slots * sizeof(uint32_t)}), 0), table,
        cells.params};
    auto node = frame.compute("irradiance_grid/resolve", shaders::irradianceGridResolve);
    node.uniformData(shared::SLOT_GRID_PARAMS, cells.params)
        .read(shared::SLOT_GRID_TABLE, table)
        .read(shared::SLOT_GRID_CELLS, cells.cells)
        .read(shared::SLOT_GRID_COUNTERS, cells.counters);
    grid.lookUp = node.update(shared::SLOT_GRID_LOOK_UP, grid.lookUp);
    node.dispatchIndirect(groups.buffer, groups.cells);
    return grid;
}

void bindGrid(graph::ComputeNode& node, const IrradianceGrid& grid,
              const residency::SceneHandles& scene, const accel::AccelHandles& accel) {
    accel::bindTraversal(node, accel, scene);
    node.uniformData(shared::SLOT_GRID_PARAMS, grid.params)
        .texels(shared::SLOT_GRID_LOOK_UP, grid.lookUp, graph::Format::RGBA32Uint);
}

}  // namespace lampyris::photons
