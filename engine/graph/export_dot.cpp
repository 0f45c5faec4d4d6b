#include <fmt/format.h>

#include "graph/export.h"
#include "graph/versions.h"

namespace lampyris::graph {
namespace {

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result;
}

std::string barrierLine(const Frame& frame, const Barrier& barrier) {
    std::string line = fmt::format("{}: {} -> {}", frame.resources()[barrier.resource].name,
                                   describe(barrier.source), describe(barrier.destination));
    if (barrier.isImage) {
        line += fmt::format(", {} -> {}", name(barrier.before), name(barrier.after));
    }
    return escaped(line) + "\\l";
}

std::string stepBox(const Frame& frame, uint32_t index, const Step& step) {
    std::string label;
    if (step.node == kNoNode) {
        label = fmt::format("{} poison\\l", index);
        for (const uint32_t resource : step.poisons) {
            label += escaped(frame.resources()[resource].name) + "\\l";
        }
    } else {
        const Node& node = frame.nodes()[step.node];
        label = fmt::format("{} {} ({})\\l", index, escaped(node.name), name(node.kind));
    }
    for (const Handover& handover : step.handover.handovers) {
        label += escaped(fmt::format("memory: {} -> {}", frame.resources()[handover.from].name,
                                     frame.resources()[handover.to].name)) +
                 "\\l";
    }
    for (const Barrier& barrier : step.barriers) label += barrierLine(frame, barrier);
    const std::string id =
        step.node == kNoNode ? fmt::format("poison{}", index) : fmt::format("node{}", step.node);
    return fmt::format("  {} [label=\"{}\"];\n", id, label);
}

}  // namespace

std::string toDot(const Frame& frame, const CompiledGraph& graph) {
    std::string dot = "digraph frame {\n  node [shape=box, fontname=monospace];\n";
    for (uint32_t step = 0; step < graph.steps.size(); ++step) {
        dot += stepBox(frame, step, graph.steps[step]);
    }
    for (const CulledNode& culled : graph.culled) {
        dot += fmt::format("  node{} [label=\"{}\", style=dashed, color=grey, tooltip=\"{}\"];\n",
                           culled.node, escaped(frame.nodes()[culled.node].name),
                           escaped(culled.reason));
    }
    Versions(frame).forEach([&](uint32_t resource, uint32_t, const VersionLinks& links) {
        for (const uint32_t reader : links.readers) {
            if (links.writer == kNoNode || links.writer == reader) continue;
            dot += fmt::format("  node{} -> node{} [label=\"{}\"];\n", links.writer, reader,
                               escaped(frame.resources()[resource].name));
        }
    });
    return dot + "}\n";
}

}  // namespace lampyris::graph
