#include "photon_gi/indirect_cost.h"

#include <algorithm>

namespace lampyris::photon_gi {

bool isIndirect(std::string_view nodeName) {
    return std::none_of(kNotIndirect.begin(), kNotIndirect.end(),
                        [&](std::string_view start) { return nodeName.starts_with(start); });
}

IndirectCost indirectCost(const execute::FrameStatistics& frame) {
    IndirectCost cost;
    for (const execute::NodeTime& node : frame.nodes) {
        if (!isIndirect(node.name)) continue;
        double& part = node.name.starts_with("gather")     ? cost.gather
                       : node.name.starts_with("upsample") ? cost.upsample
                                                           : cost.photons;
        part += node.gpuMilliseconds;
    }
    return cost;
}

}  // namespace lampyris::photon_gi
