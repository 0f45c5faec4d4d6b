/// \file Runs a compiled graph on plain bytes: transients lie where the graph put them, one over
/// another.
#pragma once

#include <cstring>
#include <map>
#include <random>
#include <vector>

#include "graph/compiled.h"
#include "graph/frame.h"

namespace lampyris::tests {

/// Each node writes bytes that depend on its index and on every byte that it may read, so that one
/// wrong byte anywhere changes what comes out.
class CpuExecutor {
 public:
    using Bytes = std::vector<uint8_t>;

    /// `garbage` seeds what stands in memory before the frame.
    CpuExecutor(const graph::Frame& frame, const graph::CompiledGraph& graph, uint64_t garbage)
        : frame_(frame), graph_(graph) {
        std::mt19937_64 random(garbage);
        for (const graph::Heap& heap : graph.heaps) {
            Bytes& bytes = heaps_.emplace_back(heap.bytes);
            for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(random());
        }
        for (uint32_t r = 0; r < frame.resources().size(); ++r) {
            if (frame.resources()[r].origin == graph::Origin::Transient) continue;
            Bytes& bytes = outside_[r];
            for (uint64_t i = 0; i < sizeOf(r); ++i)
                bytes.push_back(static_cast<uint8_t>(31 * r + i * i));
        }
    }

    /// What the frame was for: imported and history resources and outputs, by resource.
    std::map<uint32_t, Bytes> run() {
        for (const graph::Step& step : graph_.steps) {
            for (const uint32_t r : step.poisons) poison(r);
            if (step.node == graph::kNoNode) continue;
            const graph::Node& node = frame_.nodes()[step.node];
            if (node.kind == graph::NodeKind::Transfer) {
                for (const graph::Copy& copy : node.copies) runCopy(copy);
            } else {
                runShader(step.node, node);
            }
        }
        std::map<uint32_t, Bytes> results = outside_;
        for (const auto& output : frame_.outputs()) {
            const uint8_t* first = at(output.resource);
            results[output.resource] = Bytes(first, first + sizeOf(output.resource));
        }
        return results;
    }

 private:
    [[nodiscard]] uint64_t sizeOf(uint32_t resource) const {
        const graph::ResourceInfo& info = frame_.resources()[resource];
        const graph::Extent& extent = info.image.extent;
        return info.isImage ? uint64_t{extent.width} * extent.height * info.image.layers *
                                  graph::bytesPerTexel(info.image.format)
                            : info.buffer.bytes;
    }

    uint8_t* at(uint32_t resource) {
        const auto found = outside_.find(resource);
        if (found != outside_.end()) return found->second.data();
        const graph::CompiledResource& place = graph_.resources[resource];
        return heaps_.at(place.heap).data() + place.offset;
    }

    void poison(uint32_t resource) {
        for (uint64_t i = 0; i < sizeOf(resource); i += 4) {
            std::memcpy(at(resource) + i, &graph::kPoisonWord, 4);
        }
    }

    void runCopy(const graph::Copy& copy) {
        uint8_t* target = at(copy.targetResource);
        if (copy.kind == graph::Copy::Kind::Fill) {
            for (uint64_t i = 0; i < copy.bytes; i += 4)
                std::memcpy(target + i, &copy.fillValue, 4);
            return;
        }
        const uint64_t bytes = copy.bytes != 0 ? copy.bytes : sizeOf(copy.targetResource);
        std::memcpy(target + copy.targetOffset, at(copy.sourceResource) + copy.sourceOffset, bytes);
    }

    void runShader(uint32_t index, const graph::Node& node) {
        uint64_t state = 0x9e3779b97f4a7c15u * (index + 1);
        for (const graph::Use& use : node.uses) {
            const bool loads = graph::reads(use.access) || use.access == graph::Access::ColorWrite;
            if (!loads || use.clears) continue;
            const uint8_t* bytes = at(use.resource);
            for (uint64_t i = 0; i < sizeOf(use.resource); ++i)
                state = (state ^ bytes[i]) * 0x100000001b3u;
        }
        for (const graph::Use& use : node.uses) {
            if (!graph::writes(use.access)) continue;
            std::mt19937_64 random(state ^ use.resource);
            uint8_t* bytes = at(use.resource);
            for (uint64_t i = 0; i < sizeOf(use.resource); ++i)
                bytes[i] = static_cast<uint8_t>(random());
        }
    }

    const graph::Frame& frame_;
    const graph::CompiledGraph& graph_;
    std::vector<Bytes> heaps_;
    std::map<uint32_t, Bytes> outside_;
};

}  // namespace lampyris::tests
