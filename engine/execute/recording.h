/// \file What recording one frame needs, and the recorders of the kinds of nodes.
#pragma once

#include <vulkan/vulkan.h>

#include "core/result.h"
#include "execute/bindings.h"
#include "execute/frame_slot.h"
#include "execute/pipelines.h"
#include "execute/resources.h"
#include "graph/compiled.h"
#include "graph/frame.h"

namespace lampyris::execute {

struct Recording {
    gpu::Device& device;
    const graph::Frame& frame;
    const graph::CompiledGraph& graph;
    const Resources& resources;
    const Samplers& samplers;
    Pipelines& pipelines;
    FrameSlot& slot;
    VkCommandBuffer commands;
    bool timed;
};

/// Records all steps and their barriers; fills in the slot's pending frame.
core::Result<PendingFrame> recordFrame(Recording& recording);

/// Each records one node. Errors name it.
core::Result<void> recordCompute(Recording& recording, const graph::Node& node);
core::Result<void> recordRaster(Recording& recording, const graph::Node& node);
void recordTransfer(Recording& recording, const graph::Node& node, const graph::Step& step);
/// Fills transients with kPoisonWord, so that what reads them too early is seen.
void recordPoison(Recording& recording, const graph::Step& step);

}  // namespace lampyris::execute
