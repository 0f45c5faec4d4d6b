/// \file Replays a compiled graph and proves that each node meets its images in the right layout,
/// and that whatever a node needs has been written and not been lost since.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "graph/compiled.h"
#include "graph/frame.h"

namespace lampyris::tests {

/// What the world outside does with what the frame left; None where it does nothing.
inline graph::Access accessAfterFrame(const graph::Frame& frame, uint32_t resource) {
    const graph::ResourceInfo& info = frame.resources()[resource];
    if (info.origin == graph::Origin::Imported) return info.importedAs;
    if (info.origin == graph::Origin::History) return graph::Access::Sampled;
    const auto& outputs = frame.outputs();
    const bool isOutput = std::any_of(outputs.begin(), outputs.end(), [&](const auto& output) {
        return output.resource == resource;
    });
    return isOutput ? graph::Access::TransferRead : graph::Access::None;
}

class ContentsChecker {
 public:
    ContentsChecker(const graph::Frame& frame, const graph::CompiledGraph& graph)
        : frame_(frame), graph_(graph) {}

    /// What is wrong, a sentence each; empty where nothing is.
    [[nodiscard]] std::vector<std::string> run() {
        for (uint32_t r = 0; r < frame_.resources().size(); ++r) replay(r);
        return std::move(problems_);
    }

 private:
    /// Layouts and contents of one resource, step by step.
    void replay(uint32_t resource) {
        const graph::ResourceInfo& info = frame_.resources()[resource];
        const bool previous = info.origin == graph::Origin::History && info.historyPrevious;
        bool filled = info.origin == graph::Origin::Imported || previous;
        graph::Layout layout = layoutBefore(info);
        const auto apply = [&](const std::vector<graph::Barrier>& barriers) {
            for (const graph::Barrier& barrier : barriers) {
                if (barrier.resource != resource) continue;
                if (info.isImage && barrier.before != layout && !barrier.discards) {
                    problem(resource, "a barrier comes from a layout that it does not have");
                }
                layout = barrier.after;
                if (barrier.discards) filled = false;
            }
        };
        for (const graph::Step& step : graph_.steps) {
            for (const graph::Handover& pair : step.handover.handovers) {
                if (pair.from == resource) filled = false;
            }
            apply(step.barriers);
            for (const uint32_t poisoned : step.poisons) {
                if (poisoned == resource) filled = false;
            }
            if (step.node != graph::kNoNode)
                visit(frame_.nodes()[step.node], resource, layout, filled);
        }
        apply(graph_.finalBarriers);
        if (info.isImage && touched(resource)) checkEnd(resource, layout);
    }

    /// History waits as Sampled, imported images as they were imported.
    static graph::Layout layoutBefore(const graph::ResourceInfo& info) {
        const bool current = info.origin == graph::Origin::History && !info.historyPrevious;
        const bool history = info.origin == graph::Origin::History;
        if (!info.isImage || current || info.origin == graph::Origin::Transient) {
            return graph::Layout::Undefined;
        }
        const graph::Access before = history ? graph::Access::Sampled : info.importedAs;
        return graph::layoutFor(graph::outsideTouches(before).accesses(), info.image.format)
            .value_or(graph::Layout::Undefined);
    }

    void checkEnd(uint32_t resource, graph::Layout layout) {
        const graph::ResourceInfo& info = frame_.resources()[resource];
        const graph::Access after = accessAfterFrame(frame_, resource);
        const auto wanted =
            graph::layoutFor(graph::outsideTouches(after).accesses(), info.image.format);
        const bool wrong = after != graph::Access::None && layout != wanted;
        if (wrong || layout != graph_.resources[resource].endLayout) {
            problem(resource, "it ends the frame in the wrong layout");
        }
    }

    void visit(const graph::Node& node, uint32_t resource, graph::Layout layout, bool& filled) {
        const graph::ResourceInfo& info = frame_.resources()[resource];
        for (const graph::Use& use : node.uses) {
            if (use.resource != resource) continue;
            graph::AccessSet access;
            access.add(use.access);
            if (info.isImage && graph::layoutFor(access, info.image.format) != layout) {
                problem(resource, "node '" + node.name + "' meets it in the wrong layout");
            }
            const bool loads = graph::reads(use.access) || use.access == graph::Access::ColorWrite;
            if (((loads && !use.clears) || use.partial) && !filled) {
                problem(resource, "node '" + node.name + "' reads what is not there");
            }
            if (graph::writes(use.access)) filled = true;
        }
    }

    [[nodiscard]] bool touched(uint32_t resource) const {
        return graph_.resources[resource].firstStep != graph::kNoStep;
    }

    void problem(uint32_t resource, const std::string& text) {
        problems_.push_back("'" + frame_.resources()[resource].name + "': " + text);
    }

    const graph::Frame& frame_;
    const graph::CompiledGraph& graph_;
    std::vector<std::string> problems_;
};

}  // namespace lampyris::tests
