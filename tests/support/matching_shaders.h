/// \file Shaders for graph tests that are not about shaders: their slots are made to fit the nodes.
#pragma once

#include <algorithm>
#include <deque>
#include <string>
#include <vector>

#include "graph/frame.h"

namespace lampyris::tests {

/// Keeps the shaders of one frame alive. Call match() when every node is declared.
class MatchingShaders {
 public:
    graph::Shader& next() {
        graph::Shader& shader = shaders_.emplace_back();
        shader.name = "test.comp";
        return shader;
    }

    /// Gives each shader the slots that its nodes declared.
    void match(const graph::Frame& frame) {
        for (const graph::Node& node : frame.nodes()) {
            for (graph::Shader& shader : shaders_) {
                const bool drawn = std::find(node.rasterShaders.begin(), node.rasterShaders.end(),
                                             &shader) != node.rasterShaders.end();
                if (node.shader == &shader || drawn)
                    shader.slots = slots_.emplace_back(slotsOf(node));
            }
        }
    }

    static graph::SlotKind kindOf(const graph::Use& use) {
        using graph::Access;
        using graph::SlotKind;
        if (use.access == Access::Uniform) return SlotKind::UniformBuffer;
        if (use.access == Access::TexelRead) return SlotKind::UniformTexelBuffer;
        if (use.access == Access::Sampled) return SlotKind::SampledImage;
        if (use.isImage) return SlotKind::StorageImage;
        return use.texelFormat == graph::Format::Undefined ? SlotKind::StorageBuffer
                                                           : SlotKind::StorageTexelBuffer;
    }

 private:
    static std::vector<graph::ShaderSlot> slotsOf(const graph::Node& node) {
        std::vector<graph::ShaderSlot> slots;
        for (const graph::Use& use : node.uses) {
            if (use.slot == graph::kNoSlot || use.access == graph::Access::ColorWrite) continue;
            slots.push_back({.name = "slot",
                             .slot = use.slot,
                             .kind = kindOf(use),
                             .writes = graph::writes(use.access)});
        }
        for (const graph::UniformData& data : node.uniforms) {
            slots.push_back(
                {.name = "data", .slot = data.slot, .kind = graph::SlotKind::UniformBuffer});
        }
        return slots;
    }

    std::deque<graph::Shader> shaders_;
    std::deque<std::vector<graph::ShaderSlot>> slots_;
};

}  // namespace lampyris::tests
