#include "photon_gi/indirect_cost.h"

#include <algorithm>

namespace lampyris::photon_gi {

bool isIndirect(const std::string& nodeName) {
    const std::string name = execute::reportedName(nodeName);
    return std::find(kIndirect.begin(), kIndirect.end(), name) != kIndirect.end();
}

IndirectCost indirectCost(const execute::FrameStatistics& frame) {
    IndirectCost cost;
    for (const execute::NodeTime& node : frame.nodes) {
        if (!isIndirect(node.name)) continue;
        const std::string name = execute::reportedName(node.name);
        double& part = name == "gather"     ? cost.gather
                       : name == "upsample" ? cost.upsample
                                            : cost.photons;
        part += node.gpuMilliseconds;
    }
    return cost;
}

}  // namespace lampyris::photon_gi
