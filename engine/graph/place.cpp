#include "graph/place.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace lampyris::graph {
namespace {

constexpr uint64_t kNever = std::numeric_limits<uint64_t>::max();

/// A place for one tenant: by how much its heap must grow, then how much of the gap would be left
/// over.
struct Spot {
    uint32_t heap = kNoHeap;
    uint64_t offset = 0;
    uint64_t growth = kNever;
    uint64_t leftOver = kNever;
    [[nodiscard]] bool betterThan(const Spot& other) const {
        return growth != other.growth ? growth < other.growth : leftOver < other.leftOver;
    }
};

/// The gaps between those `taken` (sorted by offset) and the open end of the heap.
Spot bestSpot(const MemoryNeed& need, const std::vector<const Tenant*>& taken, uint32_t heapIndex,
              uint64_t heapBytes, uint64_t maxHeapBytes) {
    Spot best;
    uint64_t begin = 0;
    const auto consider = [&](uint64_t gapEnd, bool last) {
        const uint64_t offset = alignUp(begin, need.alignment);
        const uint64_t end = offset + need.bytes;
        if (end > gapEnd && (!last || end > maxHeapBytes)) return;
        Spot spot{.heap = heapIndex, .offset = offset, .growth = 0, .leftOver = 0};
        if (end > gapEnd) {
            spot.growth = end - gapEnd;
        } else {
            spot.leftOver = gapEnd - end;
        }
        if (spot.betterThan(best)) best = spot;
    };
    for (const Tenant* tenant : taken) {
        consider(tenant->offset, false);
        begin = std::max(begin, tenant->offset + tenant->need.bytes);
    }
    consider(heapBytes, true);
    return best;
}

std::vector<const Tenant*> conflicts(const std::vector<Tenant>& tenants, const Tenant& tenant,
                                     uint32_t heap, bool alias) {
    std::vector<const Tenant*> taken;
    for (const Tenant& other : tenants) {
        const bool inTheWay = other.heap == heap && (!alias || livesOverlap(other, tenant));
        if (inTheWay) taken.push_back(&other);
    }
    std::sort(taken.begin(), taken.end(),
              [](const Tenant* a, const Tenant* b) { return a->offset < b->offset; });
    return taken;
}

}  // namespace

uint64_t alignUp(uint64_t value, uint64_t alignment) {
    return (value + alignment - 1) / alignment * alignment;
}

bool livesOverlap(const Tenant& a, const Tenant& b) {
    return a.firstStep <= b.lastStep && b.firstStep <= a.lastStep;
}

bool bytesOverlap(const Tenant& a, const Tenant& b) {
    return a.heap == b.heap && a.offset < b.offset + b.need.bytes &&
           b.offset < a.offset + a.need.bytes;
}

std::vector<Heap> placeTenants(std::vector<Tenant>& tenants, uint64_t maxHeapBytes, bool alias) {
    std::vector<size_t> bySize(tenants.size());
    std::iota(bySize.begin(), bySize.end(), size_t{0});
    std::stable_sort(bySize.begin(), bySize.end(), [&](size_t a, size_t b) {
        return tenants[a].need.bytes > tenants[b].need.bytes;
    });
    std::vector<Heap> heaps;
    for (const size_t index : bySize) {
        Tenant& tenant = tenants[index];
        Spot best;
        for (uint32_t heap = 0; heap < heaps.size(); ++heap) {
            if (heaps[heap].memoryKind != tenant.need.memoryKind) continue;
            const Spot spot = bestSpot(tenant.need, conflicts(tenants, tenant, heap, alias), heap,
                                       heaps[heap].bytes, maxHeapBytes);
            if (spot.betterThan(best)) best = spot;
        }
        if (best.heap == kNoHeap) {
            best = {.heap = static_cast<uint32_t>(heaps.size())};
            heaps.push_back({.memoryKind = tenant.need.memoryKind});
        }
        tenant.heap = best.heap;
        tenant.offset = best.offset;
        Heap& heap = heaps[best.heap];
        heap.bytes = std::max(heap.bytes, tenant.offset + tenant.need.bytes);
        heap.alignment = std::max(heap.alignment, tenant.need.alignment);
    }
    return heaps;
}

}  // namespace lampyris::graph
