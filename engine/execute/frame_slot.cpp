#include "execute/frame_slot.h"

#include <algorithm>
#include <numeric>

namespace lampyris::execute {

core::Result<FrameSlot> FrameSlot::create(gpu::Device& device) {
    FrameSlot slot{device};
    TRY(slot.commands, gpu::Commands::create(device, "frame"));
    TRY(slot.fence, gpu::createFence(device, false, "frame"));
    return slot;
}

core::Result<VkCommandBuffer> FrameSlot::begin(gpu::Device& device, uint32_t stamps) {
    TRY_VOID(descriptors.reset());
    uniforms.reset();
    if (stamps > timestamps.capacity()) {
        constexpr uint32_t kAtLeast = 64;
        TRY(timestamps, gpu::TimestampPool::create(device, std::max(2 * stamps, kAtLeast)));
    }
    return commands.begin();
}

core::Result<FrameStatistics> FrameSlot::finish(const gpu::Device& device) {
    TRY_VOID(gpu::waitAndReset(device, fence));
    PendingFrame frame = std::move(*pending);
    pending.reset();
    const std::chrono::duration<double, std::milli> wall =
        std::chrono::steady_clock::now() - frame.begin;
    FrameStatistics statistics;
    statistics.wallMilliseconds = wall.count();
    statistics.nodes = std::move(frame.nodes);
    statistics.transientBytes = frame.transientBytes;
    statistics.transientBytesWithoutAliasing = frame.transientBytesWithoutAliasing;
    TRY(const auto intervals, timestamps.readIntervalsMilliseconds(frame.stampCount));
    statistics.gpuMilliseconds = std::accumulate(intervals.begin(), intervals.end(), 0.0);
    for (size_t i = 0; i < statistics.nodes.size(); ++i)
        if (frame.stamps[i] > 0)
            statistics.nodes[i].gpuMilliseconds = intervals[frame.stamps[i] - 1];
    return statistics;
}

}  // namespace lampyris::execute
