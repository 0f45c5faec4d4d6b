#include "accel/refit_nodes.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "accel/refit_cpu.h"
#include "accel/shaders.h"
#include "core/check.h"
#include "shared/refit.h"

namespace lampyris::accel {
namespace {

using graph::Format;
using shared::GpuRefitJob;

constexpr uint32_t kMostGroupsWide = 32768;  // [chosen] within every device's 65,535

uint32_t costParts(uint32_t nodes) {
    const uint32_t texels = shared::BVH_NODE_TEXELS * nodes;
    return (texels + shared::REFIT_COST_TEXELS - 1) / shared::REFIT_COST_TEXELS;
}

/// The jobs of one dispatch.
class Batch {
 public:
    void add(const RefitJob& job, uint32_t firstSlot, uint32_t count, uint32_t quality) {
        if (count == 0) return;
        const glm::vec3 perMetre = CellScale(job.grid).perMetre();
        jobs_.push_back({job.grid.offset, glm::vec4(perMetre, 0.0f), job.grid.cell, groups_, count,
                         firstSlot, shared::BVH_NODE_TEXELS * job.firstNode,
                         shared::BVH_NODE_TEXELS * job.nodes, job.firstVertex, job.firstIndex,
                         quality});
        groups_ += (count + shared::REFIT_THREADS - 1) / shared::REFIT_THREADS;
    }
    [[nodiscard]] bool empty() const { return jobs_.empty(); }

    /// Binds what all refit shaders read.
    void bind(graph::ComputeNode& node, graph::Buffer nodes) const {
        node.storageData(shared::SLOT_REFIT_JOBS, jobs_.data(), jobs_.size() * sizeof(GpuRefitJob))
            .texels(shared::SLOT_REFIT_NODES, nodes, Format::RGBA32Uint)
            .push(shared::RefitPush{static_cast<uint32_t>(jobs_.size()), 0, 0, 0});
    }
    void dispatch(graph::ComputeNode& node) const {
        const uint32_t wide = std::min(groups_, kMostGroupsWide);
        node.dispatch(wide, (groups_ + wide - 1) / wide);
    }

 private:
    std::vector<GpuRefitJob> jobs_;
    uint32_t groups_ = 0;
};

Batch levelOf(std::span<const RefitJob> jobs, size_t level) {
    Batch batch;
    for (uint32_t i = 0; i < jobs.size(); ++i) {
        const auto& levels = jobs[i].levels;
        if (level + 1 >= levels.size()) continue;
        batch.add(jobs[i], jobs[i].firstSlot + levels[level], levels[level + 1] - levels[level], i);
    }
    return batch;
}

graph::Buffer write(graph::ComputeNode& node, uint32_t slot, graph::Buffer buffer, bool large) {
    return large ? node.updateTexels(slot, buffer, Format::RGBA32Uint) : node.update(slot, buffer);
}

Refitted addLeaves(graph::Frame& frame, const RefitBuffers& buffers, const Batch& batch,
                   graph::Buffer quality) {
    auto node = frame.compute("refit_leaves",
                              buffers.large ? shaders::refitLeavesLarge : shaders::refitLeaves);
    batch.bind(node, buffers.nodes);
    node.texels(shared::SLOT_REFIT_SLOTS, buffers.slots, Format::R32Uint)
        .texels(shared::SLOT_REFIT_TRIANGLES, buffers.triangles, Format::RGBA32Uint)
        .texels(shared::SLOT_REFIT_POSITIONS, buffers.positions, Format::RGBA32Float)
        .texels(shared::SLOT_REFIT_INDICES, buffers.indices, Format::R32Uint);
    Refitted done;
    done.nodes = write(node, shared::SLOT_REFIT_NEW_NODES, buffers.nodes, buffers.large);
    done.triangles =
        write(node, shared::SLOT_REFIT_NEW_TRIANGLES, buffers.triangles, buffers.large);
    done.quality = node.update(shared::SLOT_REFIT_QUALITY, quality);
    batch.dispatch(node);
    return done;
}

graph::Buffer addLevel(graph::Frame& frame, const RefitBuffers& buffers, const Batch& batch,
                       size_t level, graph::Buffer nodes) {
    auto node = frame.compute("refit_levels/" + std::to_string(level),
                              buffers.large ? shaders::refitLevelLarge : shaders::refitLevel);
    batch.bind(node, nodes);
    node.texels(shared::SLOT_REFIT_SLOTS, buffers.slots, Format::R32Uint);
    const auto written = write(node, shared::SLOT_REFIT_NEW_NODES, nodes, buffers.large);
    batch.dispatch(node);
    return written;
}

graph::Buffer addCost(graph::Frame& frame, std::span<const RefitJob> jobs, graph::Buffer nodes,
                      graph::Buffer quality) {
    Batch batch;
    auto next = static_cast<uint32_t>(jobs.size());
    for (const RefitJob& job : jobs) {
        const uint32_t count = 1 + costParts(job.nodes);
        batch.add(job, 0, count, next);
        next += count;
    }
    auto node = frame.compute("refit_sah", shaders::refitSah);
    batch.bind(node, nodes);
    const auto written = node.update(shared::SLOT_REFIT_QUALITY, quality);
    batch.dispatch(node);
    return written;
}

}  // namespace

Refitted addRefit(graph::Frame& frame, const RefitBuffers& buffers,
                  std::span<const RefitJob> jobs) {
    CHECK(jobs.size() > size_t{0});
    size_t levels = 0;
    uint64_t words = jobs.size();
    for (const RefitJob& job : jobs) {
        levels = std::max(levels, job.levels.size());
        words += 1 + costParts(job.nodes);
    }
    auto clear = frame.transfer("refit_clear");
    const auto quality = clear.fill(frame.buffer("refit quality", {words * sizeof(uint32_t)}), 0);
    Refitted done = addLeaves(frame, buffers, levelOf(jobs, 0), quality);
    for (size_t level = 1; level + 1 < levels; ++level)
        done.nodes = addLevel(frame, buffers, levelOf(jobs, level), level, done.nodes);
    done.quality = addCost(frame, jobs, done.nodes, done.quality);
    return done;
}

std::vector<RefitQuality> readQuality(std::span<const uint32_t> nodes,
                                      std::span<const std::byte> bytes) {
    std::vector<RefitQuality> result;
    size_t next = nodes.size();
    for (size_t i = 0; i < nodes.size(); ++i) {
        const size_t count = 1 + costParts(nodes[i]);
        CHECK(((next + count) * sizeof(float)) <= bytes.size());
        uint32_t dropped = 0;
        std::vector<float> areas(count);
        std::memcpy(&dropped, bytes.data() + i * sizeof(uint32_t), sizeof(dropped));
        std::memcpy(areas.data(), bytes.data() + next * sizeof(float), count * sizeof(float));
        result.push_back({dropped, costOf(areas[0], std::span(areas).subspan(1))});
        next += count;
    }
    return result;
}

}  // namespace lampyris::accel
