/// \file Where transients lie in memory: things whose lives do not overlap may share bytes.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/compile.h"
#include "graph/compiled.h"

namespace lampyris::graph {

/// One transient to place. It is alive from its first to its last step, both included.
struct Tenant {
    uint32_t resource = 0;
    uint32_t firstStep = 0;
    uint32_t lastStep = 0;
    MemoryNeed need;
    uint32_t heap = kNoHeap;  ///< out
    uint64_t offset = 0;      ///< out
};

[[nodiscard]] uint64_t alignUp(uint64_t value, uint64_t alignment);
[[nodiscard]] bool livesOverlap(const Tenant& a, const Tenant& b);
[[nodiscard]] bool bytesOverlap(const Tenant& a, const Tenant& b);

/// Fills in heap and offset of each tenant, the biggest first, each in the smallest gap that holds
/// it. Gives back the heaps. With `alias` false no two tenants share a byte.
[[nodiscard]] std::vector<Heap> placeTenants(std::vector<Tenant>& tenants, uint64_t maxHeapBytes,
                                             bool alias);

}  // namespace lampyris::graph
