#include <chrono>

#include "execute/barriers.h"
#include "execute/recording.h"

namespace lampyris::execute {
namespace {

using Clock = std::chrono::steady_clock;

core::Result<void> recordNode(Recording& recording, const graph::Step& step) {
    const graph::Node& node = recording.frame.nodes()[step.node];
    const gpu::Label label{recording.device, recording.commands, node.name};
    switch (node.kind) {
        case graph::NodeKind::Compute:
            return recordCompute(recording, node);
        case graph::NodeKind::Raster:
            return recordRaster(recording, node);
        case graph::NodeKind::Transfer:
            recordTransfer(recording, node, step);
            return {};
        case graph::NodeKind::Host:
            break;
    }
    return core::error("node {}: a host node cannot be recorded", node.name);
}

core::Result<void> checkGroups(const gpu::Device& device, const graph::Node& node) {
    const auto& most = device.limits().core.maxComputeWorkGroupCount;
    for (size_t axis = 0; axis < 3; ++axis)
        if (node.groups[axis] > most[axis])
            return core::error(
                "node {}: {} workgroups along axis {} are more than the device's "
                "maxComputeWorkGroupCount, {}",
                node.name, node.groups[axis], axis, most[axis]);
    return {};
}

/// Times one step after the other: a stamp stands for all that was recorded before it. lavapipe
/// takes a stamp only when something makes it flush: without the second barrier a step that needs
/// none before it would run first, and its time would go to the step before [measured].
/// Under validation there are no such barriers, which would hide what the graph's own lack.
uint32_t stamp(const Recording& recording, uint32_t index) {
    if (!recording.timed) return 0;
    const bool alone = !recording.device.validated();
    if (alone) gpu::fullBarrier(recording.commands);
    recording.slot.timestamps.write(recording.commands, index);
    if (alone) gpu::fullBarrier(recording.commands);
    return index;
}

}  // namespace

core::Result<PendingFrame> recordFrame(Recording& recording) {
    PendingFrame pending;
    pending.begin = Clock::now();
    if (recording.timed) recording.slot.timestamps.reset(recording.commands);
    gpu::fullBarrier(recording.commands);
    stamp(recording, 0);
    uint32_t last = 0;
    for (const graph::Step& step : recording.graph.steps) {
        const auto begin = Clock::now();
        recordHandover(recording.commands, step.handover);
        recordBarriers(recording.commands, step.barriers, recording.resources);
        if (step.node == graph::kNoNode) {
            recordPoison(recording, step);
            stamp(recording, ++last);
            continue;
        }
        TRY_VOID(recordNode(recording, step));
        pending.stamps.push_back(stamp(recording, ++last));
        const std::chrono::duration<double, std::milli> spent = Clock::now() - begin;
        pending.nodes.push_back({recording.frame.nodes()[step.node].name, 0.0, spent.count()});
    }
    recordBarriers(recording.commands, recording.graph.finalBarriers, recording.resources);
    pending.stampCount = recording.timed ? last + 1 : 0;
    return pending;
}

core::Result<void> recordCompute(Recording& recording, const graph::Node& node) {
    TRY_VOID(checkGroups(recording.device, node));
    TRY(const Program program, recording.pipelines.compute(*node.shader, node.specialisations));
    TRY(const VkDescriptorSet set, makeDescriptorSet(recording, node, *program.layout));
    const VkCommandBuffer commands = recording.commands;
    const VkPipelineLayout layout = program.layout->pipeline.get();
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, program.pipeline);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1, &set, 0,
                            nullptr);
    const uint32_t pushBytes = program.layout->pushBytes;
    if (pushBytes > 0) {
        if (node.push.size() < pushBytes)
            return core::error("node {}: pushes {} bytes, its shader takes {}", node.name,
                               node.push.size(), pushBytes);
        vkCmdPushConstants(commands, layout, program.layout->pushStages, 0, pushBytes,
                           node.push.data());
    }
    if (node.indirectResource)
        vkCmdDispatchIndirect(commands, recording.resources.buffer(*node.indirectResource).get(),
                              node.indirectOffset);
    else
        vkCmdDispatch(commands, node.groups[0], node.groups[1], node.groups[2]);
    return {};
}

}  // namespace lampyris::execute
