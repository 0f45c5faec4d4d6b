/// \file What graph tests share: a frame, shaders that fit its nodes, and views of what was
/// compiled.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "graph/compile.h"
#include "support/matching_shaders.h"

namespace lampyris::graph {

constexpr ImageDesc kColour{Format::RGBA16Float, {16, 8}};
constexpr ImageDesc kDepth{Format::D32Float, {16, 8}};
constexpr BufferDesc kBytes{1024};

class GraphTest : public testing::Test {
 protected:
    ComputeNode compute(const std::string& name) { return frame.compute(name, shaders.next()); }
    /// A node that writes a new buffer.
    Buffer source(const std::string& name) {
        return compute(name).write(0, frame.buffer(name + " out", kBytes));
    }
    /// Ends a raster node: its slots are matched to one shader.
    void finish(RasterNode& node) { node.record({&shaders.next()}, {}); }

    CompiledGraph compiled(const CompileOptions& options = {}) {
        shaders.match(frame);
        auto result = compile(frame, options);
        EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().message);
        return result.ok() ? std::move(result).value() : CompiledGraph{};
    }
    /// The error, or "" where there is none.
    std::string failure(const CompileOptions& options = {}) {
        shaders.match(frame);
        const auto result = compile(frame, options);
        return result.ok() ? "" : result.error().message;
    }

    std::vector<std::string> names(const CompiledGraph& graph) const {
        std::vector<std::string> list;
        for (const Step& step : graph.steps) {
            list.push_back(step.node == kNoNode ? "poison" : frame.nodes()[step.node].name);
        }
        return list;
    }
    const Step& step(const CompiledGraph& graph, const std::string& name) const {
        for (const Step& step : graph.steps) {
            if (step.node != kNoNode && frame.nodes()[step.node].name == name) return step;
        }
        ADD_FAILURE() << "no step runs " << name;
        static const Step kNone;
        return kNone;
    }
    /// The barriers before a node as text: "x: compute StorageWrite -> compute StorageRead".
    std::vector<std::string> barriers(const CompiledGraph& graph, const std::string& name) const {
        return texts(step(graph, name).barriers);
    }
    std::vector<std::string> texts(const std::vector<Barrier>& barriers) const {
        std::vector<std::string> list;
        for (const Barrier& barrier : barriers) {
            std::string text = frame.resources()[barrier.resource].name + ": " +
                               describe(barrier.source) + " -> " + describe(barrier.destination);
            if (barrier.isImage) {
                text += std::string(", ") + graph::name(barrier.before) + " -> " +
                        graph::name(barrier.after);
            }
            list.push_back(barrier.discards ? text + ", discards" : text);
        }
        return list;
    }

    Frame frame;
    tests::MatchingShaders shaders;
};

using Texts = std::vector<std::string>;

}  // namespace lampyris::graph
