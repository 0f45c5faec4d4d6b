/// \file Timestamps on the device.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <vector>

#include "core/result.h"
#include "gpu/device.h"
#include "gpu/handle.h"

namespace lampyris::gpu {

class TimestampPool {
 public:
    TimestampPool() = default;
    static core::Result<TimestampPool> create(Device& device, uint32_t capacity);

    [[nodiscard]] uint32_t capacity() const { return capacity_; }
    /// Must be recorded before the first write of a frame.
    void reset(VkCommandBuffer commands) const;
    /// The time when everything recorded before is done.
    void write(VkCommandBuffer commands, uint32_t index) const;
    /// Milliseconds from stamp i to stamp i + 1, for the first `count` stamps; waits for them.
    core::Result<std::vector<double>> readIntervalsMilliseconds(uint32_t count) const;

 private:
    Handle<VkQueryPool, vkDestroyQueryPool> pool_;
    uint32_t capacity_ = 0;
    double millisecondsPerTick_ = 0.0;
    uint64_t mask_ = 0;  ///< of the bits that count
};

}  // namespace lampyris::gpu
