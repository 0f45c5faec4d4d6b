#include <algorithm>

#include "graph/episodes.h"

namespace lampyris::graph {
namespace {

/// Whether the two copies of one node must not overlap in time.
bool conflict(const Copy& earlier, const Copy& later) {
    const auto overlaps = [](uint64_t a, uint64_t aBytes, uint64_t b, uint64_t bBytes) {
        return a < b + bBytes && b < a + aBytes;
    };
    const bool rereads = earlier.targetResource == later.sourceResource;
    const bool rewritesSource = earlier.sourceResource == later.targetResource;
    const bool sameTarget = earlier.targetResource == later.targetResource;
    const bool toLayers = earlier.kind == Copy::Kind::BufferToImage && later.kind == earlier.kind;
    const bool toBytes = later.bytes != 0 && earlier.bytes != 0 && !toLayers;
    const bool apart = (toLayers && earlier.targetLayer != later.targetLayer) ||
                       (toBytes && !overlaps(earlier.targetOffset, earlier.bytes,
                                             later.targetOffset, later.bytes));
    return rereads || rewritesSource || (sameTarget && !apart);
}

std::vector<uint32_t> copyBarriers(const std::vector<Copy>& copies) {
    std::vector<uint32_t> barriers;
    uint32_t open = 0;  // first copy since the last barrier
    for (uint32_t i = 1; i < copies.size(); ++i) {
        const bool needed =
            std::any_of(copies.begin() + open, copies.begin() + i,
                        [&](const Copy& earlier) { return conflict(earlier, copies[i]); });
        if (!needed) continue;
        barriers.push_back(i);
        open = i;
    }
    return barriers;
}

}  // namespace

std::vector<Step> makeSteps(const Frame& frame, const std::vector<uint32_t>& nodes, bool poison) {
    std::vector<Step> steps;
    std::vector<bool> touched(frame.resources().size(), false);
    for (const uint32_t node : nodes) {
        Step poisoning;
        for (const Use& use : frame.nodes()[node].uses) {
            const bool transient = frame.resources()[use.resource].origin == Origin::Transient;
            if (transient && !touched[use.resource]) poisoning.poisons.push_back(use.resource);
            touched[use.resource] = true;
        }
        if (poison && !poisoning.poisons.empty()) steps.push_back(std::move(poisoning));
        Step step;
        step.node = node;
        step.copyBarriers = copyBarriers(frame.nodes()[node].copies);
        steps.push_back(std::move(step));
    }
    return steps;
}

}  // namespace lampyris::graph
