/// \file What one frame in flight owns: commands, descriptor sets, uniforms, timestamps.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "execute/statistics.h"
#include "execute/uniform_ring.h"
#include "gpu/commands.h"
#include "gpu/descriptors.h"
#include "gpu/query_pool.h"
#include "gpu/sync.h"

namespace lampyris::execute {

/// A frame that the device may still be working on.
struct PendingFrame {
    std::vector<NodeTime> nodes;   ///< device times still 0
    std::vector<uint32_t> stamps;  ///< by node: the index of the timestamp at its end; 0: none
    uint32_t stampCount = 0;
    std::chrono::steady_clock::time_point begin;
    uint64_t transientBytes = 0;
    uint64_t transientBytesWithoutAliasing = 0;
};

class FrameSlot {
 public:
    static core::Result<FrameSlot> create(gpu::Device& device);

    /// Makes room for the stamps and begins recording. The slot must not be pending.
    core::Result<VkCommandBuffer> begin(gpu::Device& device, uint32_t stamps);
    /// Waits for the pending frame and reads its times.
    core::Result<FrameStatistics> finish(const gpu::Device& device);

    gpu::Commands commands;
    gpu::Fence fence;
    gpu::DescriptorPool descriptors;
    UniformRing uniforms;
    gpu::TimestampPool timestamps;
    std::optional<PendingFrame> pending;

 private:
    explicit FrameSlot(gpu::Device& device) : descriptors(device), uniforms(device) {}
};

}  // namespace lampyris::execute
