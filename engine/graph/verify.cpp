#include "graph/verify.h"

#include <set>

namespace lampyris::graph {

core::Result<void> verify(const Frame& frame, const std::vector<Frame::Output>& outputs) {
    TRY_VOID(verifyHandles(frame, outputs));
    for (const Node& node : frame.nodes()) {
        TRY_VOID(verifySizes(frame, node));
        TRY_VOID(verifySlots(frame, node));
    }
    std::set<std::string> histories;
    for (const ResourceInfo& info : frame.resources()) {
        if (info.origin != Origin::History || !info.historyPrevious) continue;
        if (histories.insert(info.name).second) continue;
        return core::error("render graph: history image '{}' is declared twice", info.name);
    }
    return {};
}

}  // namespace lampyris::graph
