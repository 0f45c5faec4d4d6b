/// \file What compile() makes of a Frame: steps in order, every barrier, and where transients lie
/// in memory.
///
/// The executor opens each frame with one full memory barrier (all commands → all commands), so
/// barriers here speak of this frame alone. Per step it then does, in this order: `handover` as one
/// global memory barrier in a call of its own; `barriers` in one call; the node (or the poisoning).
/// Last, `finalBarriers`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "graph/touch.h"

namespace lampyris::graph {

constexpr uint32_t kNoNode = 0xffffffffu;
constexpr uint32_t kNoStep = 0xffffffffu;
constexpr uint32_t kNoHeap = 0xffffffffu;

/// A dependency on one resource. For buffers `before` and `after` mean nothing.
struct Barrier {
    uint32_t resource = 0;
    bool isImage = false;
    /// All touches since the previous barrier. Empty: none in this frame (an image's first layout);
    /// take the destination as source, which chains it to the frame's opening barrier and to
    /// `handover`.
    TouchSet source{};
    TouchSet destination{};  ///< all touches until the next barrier
    Layout before = Layout::Undefined;
    Layout after = Layout::Undefined;
    bool discards = false;  ///< what it held is lost (then `before` is Undefined)
};

/// Memory that passes from one resource to the next, which starts with undefined contents.
struct Handover {
    uint32_t from = 0;
    uint32_t to = 0;
};

/// A global memory barrier: all earlier users of the memory → the first touches of the new ones.
struct MemoryBarrier {
    TouchSet source{};
    TouchSet destination{};
    std::vector<Handover> handovers{};  ///< empty: there is nothing to do
};

/// Runs one node, or (debug mode) fills transients with kPoisonWord as a transfer.
struct Step {
    uint32_t node = kNoNode;          ///< index in Frame::nodes()
    std::vector<uint32_t> poisons{};  ///< resources to fill; only where `node` is kNoNode
    MemoryBarrier handover;
    std::vector<Barrier> barriers{};
    /// Transfer nodes: indices of the copies that need a transfer → transfer memory barrier before
    /// them, because they touch what an earlier copy of the same node wrote, or write what it read.
    std::vector<uint32_t> copyBarriers{};
};

constexpr uint32_t kPoisonWord = 0x7fc0deadu;  ///< a NaN as a float, out of any range as an index

/// A node that does not run, and why, as a sentence.
struct CulledNode {
    uint32_t node = 0;
    std::string reason;
};

/// A block of transient memory. Resources of different memory kinds never share one.
struct Heap {
    uint64_t bytes = 0;
    uint64_t alignment = 1;
    uint32_t memoryKind = 0;  ///< as MemoryModel gave it
};

/// One per ResourceInfo of the Frame, at the same index.
struct CompiledResource {
    AccessSet accesses;  ///< what it must be created for; empty: no step touches it
    uint32_t firstStep = kNoStep;
    uint32_t lastStep = kNoStep;           ///< steps.size() where it is still read after the frame
    uint32_t heap = kNoHeap;               ///< touched transients only
    uint64_t offset = 0;                   ///< bytes from the heap's start
    uint64_t bytes = 0;                    ///< bytes taken there
    Layout endLayout = Layout::Undefined;  ///< images: after finalBarriers
};

/// A history pair. The executor swaps the two for the next frame only where `currentWritten`.
/// Both rest in restLayout(); both are created for the accesses of the two together.
struct HistoryPair {
    uint32_t previous = 0;
    uint32_t current = 0;
    bool currentWritten = false;
};

struct CompiledGraph {
    std::vector<Step> steps;
    /// Imported → importedAs, history → Sampled, outputs that are transient → TransferRead.
    std::vector<Barrier> finalBarriers;
    std::vector<CulledNode> culled;
    std::vector<CompiledResource> resources;
    std::vector<HistoryPair> history;
    std::vector<Heap> heaps;
    uint64_t transientBytes = 0;                 ///< sum over heaps
    uint64_t transientBytesWithoutAliasing = 0;  ///< had each transient memory of its own
    /// Equal hashes: the same transients with the same descriptions, accesses and places, at the
    /// same indices; the executor may keep its physical resources.
    uint64_t layoutHash = 0;
};

}  // namespace lampyris::graph
