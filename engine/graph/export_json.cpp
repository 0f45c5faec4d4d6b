#include <nlohmann/json.hpp>

#include "graph/export.h"

namespace lampyris::graph {
namespace {

using Json = nlohmann::ordered_json;

Json touchesJson(const TouchSet& touches) {
    Json list = Json::array();
    touches.forEach([&](Touch touch) {
        list.push_back(std::string(name(touch.kind)) + ' ' + name(touch.access));
    });
    return list;
}

Json barrierJson(const Frame& frame, const Barrier& barrier) {
    Json json{{"resource", frame.resources()[barrier.resource].name},
              {"source", touchesJson(barrier.source)},
              {"destination", touchesJson(barrier.destination)}};
    if (barrier.isImage) {
        json["before"] = name(barrier.before);
        json["after"] = name(barrier.after);
    }
    json["discards"] = barrier.discards;
    return json;
}

Json barriersJson(const Frame& frame, const std::vector<Barrier>& barriers) {
    Json list = Json::array();
    for (const Barrier& barrier : barriers) list.push_back(barrierJson(frame, barrier));
    return list;
}

Json usesJson(const Frame& frame, const Node& node) {
    Json list = Json::array();
    for (const Use& use : node.uses) {
        Json json{{"resource", frame.resources()[use.resource].name},
                  {"access", name(use.access)},
                  {"version", use.version}};
        if (use.slot != kNoSlot) json["slot"] = use.slot;
        list.push_back(std::move(json));
    }
    return list;
}

Json handoverJson(const Frame& frame, const MemoryBarrier& barrier) {
    Json pairs = Json::array();
    for (const Handover& handover : barrier.handovers) {
        pairs.push_back({{"from", frame.resources()[handover.from].name},
                         {"to", frame.resources()[handover.to].name}});
    }
    return {{"source", touchesJson(barrier.source)},
            {"destination", touchesJson(barrier.destination)},
            {"pairs", std::move(pairs)}};
}

Json stepJson(const Frame& frame, const Step& step) {
    Json json;
    if (step.node == kNoNode) {
        Json poisons = Json::array();
        for (const uint32_t resource : step.poisons) {
            poisons.push_back(frame.resources()[resource].name);
        }
        json["poisons"] = std::move(poisons);
    } else {
        const Node& node = frame.nodes()[step.node];
        json["node"] = node.name;
        json["kind"] = name(node.kind);
        json["uses"] = usesJson(frame, node);
    }
    if (!step.handover.handovers.empty()) json["handover"] = handoverJson(frame, step.handover);
    json["barriers"] = barriersJson(frame, step.barriers);
    if (!step.copyBarriers.empty()) json["copy_barriers"] = step.copyBarriers;
    return json;
}

Json descriptionJson(const ResourceInfo& info) {
    static constexpr std::array<const char*, 3> kOrigins{"transient", "imported", "history"};
    Json json{{"name", info.name},
              {"kind", info.isImage ? "image" : "buffer"},
              {"origin", kOrigins[static_cast<size_t>(info.origin)]}};
    if (info.isImage) {
        json["format"] = name(info.image.format);
        json["width"] = info.image.extent.width;
        json["height"] = info.image.extent.height;
        json["layers"] = info.image.layers;
    } else {
        json["size"] = info.buffer.bytes;
    }
    return json;
}

Json resourceJson(const ResourceInfo& info, const CompiledResource& compiled) {
    Json json = descriptionJson(info);
    Json accesses = Json::array();
    for (uint32_t bit = 0; bit < kAccessCount; ++bit) {
        const auto access = static_cast<Access>(bit);
        if (compiled.accesses.has(access)) accesses.push_back(name(access));
    }
    json["accesses"] = std::move(accesses);
    if (compiled.firstStep != kNoStep) {
        json["first_step"] = compiled.firstStep;
        json["last_step"] = compiled.lastStep;
    }
    if (compiled.heap != kNoHeap) {
        json["heap"] = compiled.heap;
        json["offset"] = compiled.offset;
        json["bytes"] = compiled.bytes;
    }
    return json;
}

}  // namespace

std::string toJson(const Frame& frame, const CompiledGraph& graph) {
    Json steps = Json::array();
    for (const Step& step : graph.steps) steps.push_back(stepJson(frame, step));
    Json culled = Json::array();
    for (const CulledNode& entry : graph.culled) {
        culled.push_back({{"node", frame.nodes()[entry.node].name}, {"reason", entry.reason}});
    }
    Json resources = Json::array();
    for (size_t i = 0; i < graph.resources.size(); ++i) {
        resources.push_back(resourceJson(frame.resources()[i], graph.resources[i]));
    }
    Json heaps = Json::array();
    for (const Heap& heap : graph.heaps) {
        heaps.push_back({{"bytes", heap.bytes},
                         {"alignment", heap.alignment},
                         {"memory_kind", heap.memoryKind}});
    }
    const Json json{{"steps", std::move(steps)},
                    {"final_barriers", barriersJson(frame, graph.finalBarriers)},
                    {"culled", std::move(culled)},
                    {"resources", std::move(resources)},
                    {"heaps", std::move(heaps)},
                    {"transient_bytes", graph.transientBytes},
                    {"transient_bytes_without_aliasing", graph.transientBytesWithoutAliasing}};
    // A name that is not UTF-8 must not throw.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lampyris::graph
