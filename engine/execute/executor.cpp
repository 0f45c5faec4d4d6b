#include "execute/executor.h"

#include <iterator>

#include "execute/read_back.h"
#include "execute/recording.h"

namespace lampyris::execute {

Executor::Executor(gpu::Device& device)
    : device_(&device),
      memoryModel_(device),
      pipelines_(device),
      transients_(device),
      history_(device) {}

core::Result<Executor> Executor::create(gpu::Device& device) {
    Executor executor{device};
    TRY(executor.samplers_, Samplers::create(device));
    for (size_t i = 0; i < kFramesInFlight; ++i) {
        TRY(FrameSlot slot, FrameSlot::create(device));
        executor.slots_.push_back(std::move(slot));
    }
    return executor;
}

Executor::~Executor() {
    if (slots_.empty()) return;  // moved from
    device_->settle();
}

core::Result<FrameResult> Executor::run(const graph::Frame& frame,
                                        const graph::CompiledGraph& graph,
                                        const RunOptions& options) {
    TRY_VOID(finish());
    FrameSlot& slot = slots_[next_];
    TRY_VOID(submitFrame(frame, graph, options.timed));
    FrameResult result;
    TRY(result.statistics, finishSlot(slot));
    std::vector<uint32_t> wanted;
    for (const graph::Image image : options.readBackImages) wanted.push_back(image.resource);
    for (const graph::Buffer buffer : options.readBackBuffers) wanted.push_back(buffer.resource);
    TRY(auto contents, readBack(*device_, slot.commands, frame, graph, resources_, wanted));
    auto next = contents.begin();
    for (const graph::Image image : options.readBackImages)
        result.images.push_back(RawImage{frame.desc(image), std::move(*next++)});
    result.buffers.assign(std::move_iterator{next}, std::move_iterator{contents.end()});
    return result;
}

core::Result<FrameResult> Executor::run(const graph::Frame& frame, const RunOptions& options,
                                        graph::CompileOptions compileOptions) {
    compileOptions.memory = &memoryModel_;
    for (const graph::Image image : options.readBackImages)
        compileOptions.extraOutputs.push_back(image);
    TRY(const graph::CompiledGraph graph, graph::compile(frame, compileOptions));
    return run(frame, graph, options);
}

core::Result<std::optional<FrameStatistics>> Executor::runAhead(const graph::Frame& frame,
                                                                const graph::CompiledGraph& graph,
                                                                bool timed) {
    TRY_VOID(submitFrame(frame, graph, timed));
    FrameSlot& before = slots_[next_];
    if (!before.pending) return std::optional<FrameStatistics>{};
    TRY(FrameStatistics statistics, finishSlot(before));
    return std::optional{std::move(statistics)};
}

core::Result<std::optional<FrameStatistics>> Executor::finish() {
    std::optional<FrameStatistics> last;
    for (size_t i = 0; i < slots_.size(); ++i) {
        FrameSlot& slot = slots_[(next_ + i) % slots_.size()];
        if (!slot.pending) continue;
        TRY(last, finishSlot(slot));
    }
    return last;
}

core::Result<void> Executor::replaceShader(const graph::Shader& shader,
                                           std::span<const uint32_t> words) {
    TRY_VOID(device_->waitIdle());
    return pipelines_.replace(shader, words);
}

const gpu::Image& Executor::outputImage(graph::Image image) const {
    return resources_.image(image.resource);
}

core::Result<void> Executor::prepare(const graph::Frame& frame, const graph::CompiledGraph& graph) {
    // What was shown last may still be on its way to the window.
    if (transients_.wouldChange(graph) || history_.wouldChange(frame, graph))
        TRY_VOID(device_->waitIdle());
    TRY_VOID(transients_.follow(frame, graph));
    return history_.prepare(frame, graph);
}

core::Result<void> Executor::submitFrame(const graph::Frame& frame,
                                         const graph::CompiledGraph& graph, bool timed) {
    const auto begin = std::chrono::steady_clock::now();
    TRY_VOID(prepare(frame, graph));
    FrameSlot& slot = slots_[next_];
    if (slot.pending) TRY_VOID(finishSlot(slot));
    TRY(const VkCommandBuffer commands,
        slot.begin(*device_, static_cast<uint32_t>(graph.steps.size()) + 1));
    TRY(resources_, Resources::resolve(frame, graph, transients_, history_));
    Recording recording{*device_,   frame, graph,    resources_, samplers_,
                        pipelines_, slot,  commands, timed};
    TRY(PendingFrame pending, recordFrame(recording));
    TRY_VOID(slot.commands.end());
    TRY_VOID(gpu::submit(*device_, slot.commands, {.fence = slot.fence.get()}));
    pending.begin = begin;
    pending.transientBytes = graph.transientBytes;
    pending.transientBytesWithoutAliasing = graph.transientBytesWithoutAliasing;
    slot.pending = std::move(pending);
    history_.turn(frame, graph);
    next_ = (next_ + 1) % slots_.size();
    return {};
}

core::Result<FrameStatistics> Executor::finishSlot(FrameSlot& slot) {
    TRY(FrameStatistics statistics, slot.finish(*device_));
    statistics.deviceBytes = device_->memory().bytes();
    return statistics;
}

}  // namespace lampyris::execute
