#include "graph/cull.h"

#include <string>

namespace lampyris::graph {
namespace {

std::string quoted(const std::string& name) {
    return "'" + name + "'";
}

/// Marks what is needed, from the end of the frame backwards.
class Sweep {
 public:
    Sweep(const Frame& frame, const Versions& versions)
        : frame_(frame), versions_(versions), live_(frame.nodes().size(), false) {}

    void need(uint32_t resource, uint32_t version) {
        const VersionLinks* links = versions_.find(resource, version);
        if (links != nullptr && links->writer != kNoNode) keep(links->writer);
    }

    void keep(uint32_t node) {
        if (live_[node]) return;
        live_[node] = true;
        pending_.push_back(node);
    }

    std::vector<bool> run() {
        while (!pending_.empty()) {
            const uint32_t node = pending_.back();
            pending_.pop_back();
            for (const Use& use : frame_.nodes()[node].uses) {
                if (needsContents(use)) need(use.resource, use.version);
            }
        }
        return std::move(live_);
    }

 private:
    const Frame& frame_;
    const Versions& versions_;
    std::vector<bool> live_;
    std::vector<uint32_t> pending_;
};

std::string reasonOf(const Frame& frame, const Versions& versions, const Node& node) {
    std::string written;
    std::string readers;
    for (const Use& use : node.uses) {
        if (!writes(use.access)) continue;
        if (!written.empty()) written += ", ";
        written += quoted(frame.resources()[use.resource].name);
        for (const uint32_t reader : versions.find(use.resource, use.writtenVersion)->readers) {
            if (&frame.nodes()[reader] == &node) continue;
            if (!readers.empty()) readers += ", ";
            readers += quoted(frame.nodes()[reader].name);
        }
    }
    if (written.empty()) return "It writes nothing and is not kept.";
    if (readers.empty()) return "Nobody reads what it writes: " + written + ".";
    return "What it writes (" + written +
           ") is read only by nodes that are culled too: " + readers + ".";
}

core::Result<void> checkOutputs(const Frame& frame, const Versions& versions,
                                const std::vector<Frame::Output>& outputs,
                                const std::vector<bool>& live) {
    for (const Frame::Output& output : outputs) {
        const VersionLinks* links = versions.find(output.resource, output.version);
        if (links == nullptr || links->retirer == kNoNode || !live[links->retirer]) continue;
        return core::error("render graph: output '{}' is a stale handle: node '{}' rewrites it",
                           frame.resources()[output.resource].name,
                           frame.nodes()[links->retirer].name);
    }
    return {};
}

}  // namespace

core::Result<Liveness> cullNodes(const Frame& frame, const Versions& versions,
                                 const std::vector<Frame::Output>& outputs) {
    Sweep sweep(frame, versions);
    for (const Frame::Output& output : outputs) sweep.need(output.resource, output.version);
    versions.forEach([&](uint32_t resource, uint32_t version, const VersionLinks& links) {
        const bool last = links.retirer == kNoNode;
        if (last && outlivesFrame(frame.resources()[resource])) sweep.need(resource, version);
    });
    for (uint32_t node = 0; node < frame.nodes().size(); ++node) {
        if (frame.nodes()[node].keep) sweep.keep(node);
    }
    Liveness result;
    result.live = sweep.run();
    TRY_VOID(checkOutputs(frame, versions, outputs, result.live));
    for (uint32_t node = 0; node < frame.nodes().size(); ++node) {
        if (result.live[node]) continue;
        result.culled.push_back({node, reasonOf(frame, versions, frame.nodes()[node])});
    }
    return result;
}

}  // namespace lampyris::graph
