/// \file Replays a compiled graph and proves it free of hazards, knowing nothing of how it was
/// compiled.
///
/// Every two touches of the same bytes, one of them a write, must be linked by a chain of barriers
/// on the resources concerned: each barrier's source holds the first touch or something that an
/// earlier barrier made wait for it. Layouts must fit, and contents that a node needs must not have
/// been discarded.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "graph/compiled.h"
#include "graph/frame.h"
#include "support/contents_checker.h"

namespace lampyris::tests {

class HazardChecker {
 public:
    HazardChecker(const graph::Frame& frame, const graph::CompiledGraph& graph)
        : frame_(frame), graph_(graph) {}

    /// What is wrong, a sentence each; empty where nothing is.
    [[nodiscard]] std::vector<std::string> run() {
        collect();
        for (size_t later = 0; later < events_.size(); ++later) {
            for (size_t earlier = 0; earlier < later; ++earlier)
                check(events_[earlier], events_[later]);
        }
        return std::move(problems_);
    }

 private:
    /// A node's touch of a resource, or the transition that a barrier makes.
    struct Event {
        uint32_t position = 0;  ///< in step s: handover 3s, barriers 3s + 1, node 3s + 2
        uint32_t resource = 0;
        graph::TouchSet awaitsTouches;  ///< a transition: touches before it that it waits for
        graph::TouchSet awaits;         ///< a link that ends in these makes the event wait
        graph::TouchSet signals;        ///< a barrier from these waits for the event
        bool writes = false;
        std::string what;
    };
    /// A dependency that holds for the bytes of `from` and of `to`.
    struct Link {
        uint32_t position = 0;
        uint32_t from = 0;
        uint32_t to = 0;
        graph::TouchSet source;       ///< touches before it that it waits for
        graph::TouchSet continues;    ///< ends of earlier links that it waits for
        graph::TouchSet destination;  ///< what waits for it
    };

    void collect() {
        for (uint32_t step = 0; step < graph_.steps.size(); ++step) {
            const graph::Step& s = graph_.steps[step];
            for (const graph::Handover& pair : s.handover.handovers) {
                links_.push_back({3 * step, pair.from, pair.to, s.handover.source,
                                  s.handover.source, s.handover.destination});
            }
            for (const graph::Barrier& barrier : s.barriers) addBarrier(barrier, 3 * step + 1);
            const graph::Touch fill{graph::Access::TransferWrite, graph::NodeKind::Transfer};
            for (const uint32_t r : s.poisons) addTouch(r, fill, 3 * step + 2, "poison");
            if (s.node == graph::kNoNode) continue;
            const graph::Node& node = frame_.nodes()[s.node];
            for (const graph::Use& use : node.uses) {
                addTouch(use.resource, {use.access, node.kind}, 3 * step + 2, node.name);
            }
        }
        const auto end = static_cast<uint32_t>(3 * graph_.steps.size());
        for (const graph::Barrier& barrier : graph_.finalBarriers) addBarrier(barrier, end + 1);
        addEnds(end + 2);
    }

    void addEnds(uint32_t position) {
        for (uint32_t r = 0; r < frame_.resources().size(); ++r) {
            if (graph::writes(accessAfterFrame(frame_, r))) continue;
            graph::outsideTouches(accessAfterFrame(frame_, r)).forEach([&](graph::Touch touch) {
                addTouch(r, touch, position, "the world outside");
            });
        }
    }

    void addBarrier(const graph::Barrier& barrier, uint32_t position) {
        // An empty source stands for the destination's stages: it waits for no touch by itself, but
        // continues what a handover began.
        const graph::TouchSet& awaits =
            barrier.source.empty() ? barrier.destination : barrier.source;
        links_.push_back({position, barrier.resource, barrier.resource, barrier.source, awaits,
                          barrier.destination});
        const bool transition = barrier.isImage && barrier.before != barrier.after;
        if (!transition) return;
        events_.push_back({position, barrier.resource, barrier.source, awaits, barrier.destination,
                           true, "a transition"});
    }

    void addTouch(uint32_t resource, graph::Touch touch, uint32_t position,
                  const std::string& what) {
        Event event{position, resource, {}, {}, {}, graph::writes(touch.access), what};
        event.awaits.add(touch);
        event.signals.add(touch);
        events_.push_back(event);
    }

    [[nodiscard]] bool sameBytes(uint32_t a, uint32_t b) const {
        if (a == b) return true;
        const auto& x = graph_.resources[a];
        const auto& y = graph_.resources[b];
        return x.heap != graph::kNoHeap && x.heap == y.heap && x.offset < y.offset + y.bytes &&
               y.offset < x.offset + x.bytes;
    }

    [[nodiscard]] static bool meet(const graph::TouchSet& a, const graph::TouchSet& b) {
        bool any = false;
        a.forEach([&](graph::Touch touch) { any = any || b.has(touch); });
        return any;
    }

    [[nodiscard]] static bool isTransition(const Event& event) { return event.position % 3 == 1; }

    void check(const Event& earlier, const Event& later) {
        if (!earlier.writes && !later.writes) return;
        if (earlier.position == later.position || !sameBytes(earlier.resource, later.resource))
            return;
        // A transition is part of its barrier: it follows what that barrier waits for, and what
        // waits for the barrier follows it.
        if (meet(earlier.signals, later.awaitsTouches)) return;
        graph::TouchSet reached;  // what is known to come after `earlier`
        if (isTransition(earlier)) reached = earlier.signals;
        const auto concerns = [&](uint32_t r) {
            return r == earlier.resource || r == later.resource;
        };
        for (const Link& link : links_) {
            if (link.position <= earlier.position || link.position >= later.position) continue;
            if (!concerns(link.from) || !concerns(link.to)) continue;
            if (meet(link.source, earlier.signals) || meet(link.continues, reached))
                reached.add(link.destination);
        }
        if (meet(reached, later.awaits)) return;
        problems_.push_back("nothing stands between '" + earlier.what + "' and '" + later.what +
                            "' on '" + frame_.resources()[earlier.resource].name + "' / '" +
                            frame_.resources()[later.resource].name + "'");
    }

    const graph::Frame& frame_;
    const graph::CompiledGraph& graph_;
    std::vector<Event> events_;
    std::vector<Link> links_;
    std::vector<std::string> problems_;
};

}  // namespace lampyris::tests
