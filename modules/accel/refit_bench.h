/// \file What refitting deforming meshes costs, on either path, beside rebuilding and Embree.
#pragma once

#include <cstdint>
#include <vector>

#include "assets/mesh.h"
#include "core/result.h"
#include "execute/executor.h"

namespace lampyris::accel {

/// Medians, ms. Deforming the vertices is in none of them.
struct RefitTimes {
    uint64_t triangles = 0;
    uint32_t nodes = 0, depth = 0;
    double leaves = 0.0, levels = 0.0, cost = 0.0;  ///< the device's nodes
    double device = 0.0;                            ///< their sum
    double cpu = 0.0;      ///< corners, boxes and cost, into memory that the device copies from
    double upload = 0.0;   ///< that copy, and the nodes'
    double rebuild = 0.0;  ///< MEDIUM quality, flattened, with corners and the device's levels
    double embree = 0.0;   ///< Embree's refit: the commits alone
};

/// One mesh whose vertices all move, each of these in turn.
core::Result<RefitTimes> measureRefit(execute::Executor& executor, const assets::Mesh& mesh,
                                      uint32_t repeats);

/// Medians, ms, of refitting one tree of many and all of them.
struct RefitShare {
    uint32_t meshes = 0;
    uint64_t triangles = 0;  ///< of each
    double oneOnDevice = 0.0, allOnDevice = 0.0;
    double oneOnCpu = 0.0, allOnCpu = 0.0;
};

/// So many trees over copies of a mesh.
core::Result<RefitShare> measureShare(execute::Executor& executor, const assets::Mesh& mesh,
                                      uint32_t copies, uint32_t repeats);

}  // namespace lampyris::accel
