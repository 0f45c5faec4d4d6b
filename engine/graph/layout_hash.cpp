#include "graph/layout_hash.h"

#include <string_view>

namespace lampyris::graph {
namespace {

/// FNV-1a, 64 bits.
class Hash {
 public:
    void add(uint64_t value) {
        for (int byte = 0; byte < 8; ++byte) mix(static_cast<uint8_t>(value >> 8 * byte));
    }
    void add(std::string_view text) {
        add(text.size());
        for (const char c : text) mix(static_cast<uint8_t>(c));
    }
    [[nodiscard]] uint64_t value() const { return value_; }

 private:
    void mix(uint8_t byte) { value_ = (value_ ^ byte) * 0x100000001b3u; }
    uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace

uint64_t layoutHash(const Frame& frame, const CompiledGraph& graph) {
    Hash hash;
    for (const Heap& heap : graph.heaps) {
        hash.add(heap.bytes);
        hash.add(heap.alignment);
        hash.add(heap.memoryKind);
    }
    for (size_t resource = 0; resource < graph.resources.size(); ++resource) {
        const CompiledResource& compiled = graph.resources[resource];
        if (compiled.heap == kNoHeap) continue;
        const ResourceInfo& info = frame.resources()[resource];
        hash.add(info.name);
        hash.add(info.isImage ? 1u : 0u);
        hash.add(static_cast<uint64_t>(info.image.format));
        hash.add(info.image.extent.width);
        hash.add(info.image.extent.height);
        hash.add(info.image.layers);
        hash.add(info.buffer.bytes);
        hash.add(compiled.accesses.bits);
        hash.add(compiled.heap);
        hash.add(compiled.offset);
    }
    return hash.value();
}

}  // namespace lampyris::graph
