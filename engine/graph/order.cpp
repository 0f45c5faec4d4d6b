#include "graph/order.h"

#include <algorithm>
#include <random>
#include <string>

namespace lampyris::graph {
namespace {

struct Edge {
    uint32_t from = kNoNode;
    uint32_t to = kNoNode;
    uint32_t resource = 0;
};

std::vector<Edge> edgesOf(const Versions& versions) {
    std::vector<Edge> edges;
    const auto add = [&](uint32_t from, uint32_t to, uint32_t resource) {
        if (from != kNoNode && to != kNoNode && from != to) edges.push_back({from, to, resource});
    };
    versions.forEach([&](uint32_t resource, uint32_t, const VersionLinks& links) {
        for (const uint32_t reader : links.readers) {
            add(links.writer, reader, resource);
            add(reader, links.retirer, resource);
        }
        add(links.writer, links.retirer, resource);
    });
    return edges;
}

/// Every node left over waits for another one, so walking backwards must come round.
core::Error cycleError(const Frame& frame, const std::vector<Edge>& edges,
                       const std::vector<uint32_t>& waiting) {
    const auto isLeft = [&](uint32_t node) { return waiting[node] != 0; };
    uint32_t node = 0;
    while (!isLeft(node)) ++node;
    std::vector<const Edge*> walked;
    std::vector<bool> seen(waiting.size(), false);
    while (!seen[node]) {
        seen[node] = true;
        const auto cause = std::find_if(edges.begin(), edges.end(), [&](const Edge& edge) {
            return edge.to == node && isLeft(edge.from);
        });
        walked.push_back(&*cause);
        node = cause->from;
    }
    std::string path = "'" + frame.nodes()[node].name + "'";
    for (size_t i = walked.size(); i-- > 0;) {
        path += " -> '" + frame.nodes()[walked[i]->to].name + "' (through '" +
                frame.resources()[walked[i]->resource].name + "')";
        if (walked[i]->to == node) break;
    }
    return core::error("render graph: a cycle: {}", path);
}

}  // namespace

core::Result<std::vector<uint32_t>> orderNodes(const Frame& frame, const Versions& versions,
                                               uint64_t randomSeed) {
    const std::vector<Edge> edges = edgesOf(versions);
    std::vector<uint32_t> waiting(frame.nodes().size(), 0);
    std::vector<std::vector<uint32_t>> followers(frame.nodes().size());
    for (const Edge& edge : edges) {
        ++waiting[edge.to];
        followers[edge.from].push_back(edge.to);
    }
    std::vector<uint32_t> ready;
    for (uint32_t node = 0; node < waiting.size(); ++node) {
        if (waiting[node] == 0) ready.push_back(node);
    }
    std::mt19937_64 random(randomSeed);
    std::vector<uint32_t> order;
    while (!ready.empty()) {
        const auto next = randomSeed == 0
                              ? std::min_element(ready.begin(), ready.end())
                              : ready.begin() + static_cast<ptrdiff_t>(random() % ready.size());
        const uint32_t node = *next;
        ready.erase(next);
        order.push_back(node);
        for (const uint32_t follower : followers[node]) {
            if (--waiting[follower] == 0) ready.push_back(follower);
        }
    }
    if (order.size() < waiting.size()) return cycleError(frame, edges, waiting);
    return order;
}

}  // namespace lampyris::graph
