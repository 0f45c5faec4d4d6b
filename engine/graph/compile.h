/// \file compile(Frame) → CompiledGraph: check, cull, order, place in memory, derive barriers. No
/// GPU.
#pragma once

#include <cstdint>
#include <vector>

#include "core/result.h"
#include "graph/compiled.h"
#include "graph/frame.h"

namespace lampyris::graph {

/// What a transient takes in memory.
struct MemoryNeed {
    uint64_t bytes = 0;
    uint64_t alignment = 1;
    uint32_t memoryKind = 0;  ///< resources share a heap only where this is equal
};

/// How big things are on a device. The default is a plain CPU model: tight texels, 256-byte
/// alignment, images and buffers in the same heaps.
class MemoryModel {
 public:
    virtual ~MemoryModel() = default;
    [[nodiscard]] virtual MemoryNeed image(const ImageDesc& desc, AccessSet accesses) const;
    [[nodiscard]] virtual MemoryNeed buffer(const BufferDesc& desc, AccessSet accesses) const;
    /// The largest heap; a single resource above it gets a heap of its own.
    [[nodiscard]] virtual uint64_t maxHeapBytes() const { return uint64_t{1} << 30; }
};

struct CompileOptions {
    const MemoryModel* memory = nullptr;  ///< null: the default model
    uint64_t randomOrderSeed = 0;         ///< 0: ties by declaration; else a random legal order
    bool poisonTransients = false;  ///< fill each transient with kPoisonWord before its first write
    bool alias = true;              ///< false: no two transients share memory
    std::vector<Image> extraOutputs{};  ///< beside Frame::output(): say, a published image
};

/// Errors name the node and the resource: a read before any write, a stale handle, a write that
/// nobody declared, a slot missing, twice, or of another kind, a cycle, a range outside its buffer,
/// a zero size.
[[nodiscard]] core::Result<CompiledGraph> compile(const Frame& frame,
                                                  const CompileOptions& options = {});

}  // namespace lampyris::graph
