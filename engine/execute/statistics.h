/// \file What a frame cost.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lampyris::execute {

/// A node's name as reports have it: what stands before the first '/' ("tile_bin/count" is a part
/// of "tile_bin").
[[nodiscard]] inline std::string reportedName(const std::string& nodeName) {
    return nodeName.substr(0, nodeName.find('/'));
}

struct NodeTime {
    std::string name;
    double gpuMilliseconds = 0.0;  ///< 0 where the frame was not timed
    double cpuRecordMilliseconds = 0.0;
};

struct FrameStatistics {
    std::vector<NodeTime> nodes;    ///< in the order they ran
    double gpuMilliseconds = 0.0;   ///< from the frame's first timestamp to its last
    double wallMilliseconds = 0.0;  ///< from the call of run() to the device's being done
    uint64_t deviceBytes = 0;       ///< all device memory of the device's allocator
    uint64_t transientBytes = 0;
    uint64_t transientBytesWithoutAliasing = 0;
};

}  // namespace lampyris::execute
