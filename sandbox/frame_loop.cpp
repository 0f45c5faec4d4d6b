#include "frame_loop.h"

#include <algorithm>
#include <chrono>

#include "camera_choice.h"
#include "core/log.h"
#include "open_world.h"

namespace lampyris::sandbox {
namespace {

constexpr uint32_t kMostTries =
    12;  // [chosen] buffers grow by half at least: past it the device cannot hold them

core::Error overflow(const shared::FrameCounters& counters) {
    return core::error(
        "a frame does not fit: {} photons, {} tile entries and {} grid cells were dropped after {} "
        "tries",
        counters.photonsDropped, counters.pairsDropped, counters.cellsDropped, kMostTries);
}

// A frame takes its photons in batches, so this bounds time as much as memory: each path leaves one
// at least.
core::Result<void> checkPaths(uint32_t paths, const gpu::Device& device) {
    const uint64_t bytes = uint64_t{paths} * sizeof(shared::PackedPhoton);
    const uint64_t most = device.limits().largestHeapBytes;
    if (bytes <= most) return {};
    return core::error(
        "--photons {}: their photons take {} MiB or more, the device's memory is {} MiB", paths,
        bytes >> 20, most >> 20);
}

core::Result<void> checkSize(graph::Extent size, const gpu::Device& device) {
    const uint32_t most = device.limits().core.maxImageDimension2D;
    if (std::max(size.width, size.height) <= most) return {};
    return core::error("--size {}x{}: the device's limit maxImageDimension2D is {}", size.width,
                       size.height, most);
}

/// On the CPU, or in the device's nodes.
double refitMilliseconds(const accel::AccelCounts& counts, const execute::FrameStatistics& frame) {
    double sum = counts.refitMilliseconds;
    for (const execute::NodeTime& node : frame.nodes)
        if (node.name.starts_with("refit")) sum += node.gpuMilliseconds;
    return sum;
}

}  // namespace

void Dropped::add(const shared::FrameCounters& counters) {
    photons += counters.photonsDropped;
    pairs += counters.pairsDropped;
    cells += counters.cellsDropped;
}

core::Result<std::unique_ptr<FrameLoop>> FrameLoop::open(const Options& options,
                                                         const Liveness& live) {
    auto loop = std::make_unique<FrameLoop>();
    TRY(loop->device_, gpu::Device::create({options.device, options.validation, live.presentable}));
    loop->request.size = sizeOf(options);
    loop->request.settings = settingsOf(options);
    loop->outputNode_ = options.outputNode;
    loop->request.finalAlone = options.outputNode == "final";
    loop->seconds = options.time;
    loop->startSeconds_ = options.time;
    loop->timestep_ = options.timestep.value_or(0.0);
    TRY_VOID(checkSize(loop->request.size, *loop->device_));
    TRY_VOID(checkPaths(loop->request.settings.photonPaths, *loop->device_));
    TRY(execute::Executor executor, execute::Executor::create(*loop->device_));
    loop->executor_.emplace(std::move(executor));
    TRY(loop->world_, openWorld(options));
    loop->accelSettings_.rebuild.deterministic = live.repeatable;
    loop->renderer_.emplace(*loop->executor_, loop->accelSettings_);
    TRY_VOID(loop->follow());
    TRY(loop->request.camera, chooseCamera(loop->snapshot(), options.camera));
    return loop;
}

core::Result<void> FrameLoop::beginAnew() {
    TRY_VOID(device_->waitIdle());
    renderer_.emplace(*executor_, accelSettings_);
    return followEdits();
}

core::Result<void> FrameLoop::follow() {
    return renderer_->update(snapshot_.follow(world_, seconds));
}

core::Result<void> FrameLoop::followEdits() {
    return renderer_->update(snapshot_.followEdits(world_));
}

core::Result<LoopFrame> FrameLoop::tryDraw(uint64_t frameNumber, const std::string& readBack,
                                           const AddNodes& addNodes) {
    TRY_VOID(checkPaths(request.settings.photonPaths, *device_));
    LoopFrame frame;
    request.frameNumber = frameNumber;
    TRY(const photon_gi::DrawnFrame drawn, renderer_->declare(frame.declared, request));
    frame.declared.output(drawn.radiance);
    if (addNodes) addNodes(frame.declared, drawn);
    if (!frame.declared.published(outputNode_).valid())
        return core::error("--output-node {}: there is no such image; there are {}", outputNode_,
                           fmt::join(frame.declared.publishedNames(), ", "));
    TRY(frame.outcome, renderer_->run(frame.declared, drawn, readBack));
    const accel::AccelCounts counts = renderer_->accel().counts();
    frame.rebuilds = counts.rebuilds;
    frame.rebuildMilliseconds = counts.rebuildMilliseconds;
    frame.refits = counts.refits;
    frame.refitMilliseconds = refitMilliseconds(counts, frame.outcome.statistics);
    frame.sahRatioMax = counts.sahRatioMax;
    core::releaseLog();
    return frame;
}

core::Result<LoopFrame> FrameLoop::draw(uint64_t frameNumber, bool readBack) {
    seconds = startSeconds_ + static_cast<double>(frameNumber) * timestep_;
    const auto begin = std::chrono::steady_clock::now();
    TRY_VOID(follow());
    const std::chrono::duration<double, std::milli> update =
        std::chrono::steady_clock::now() - begin;
    shared::FrameCounters last{};
    Dropped dropped;
    for (uint32_t i = 0; i < kMostTries; ++i) {
        TRY(LoopFrame frame, tryDraw(frameNumber, readBack ? outputNode_ : std::string{}));
        last = frame.outcome.report.counters;
        if (!frame.outcome.report.valid) {
            dropped.add(last);
            continue;
        }
        frame.updateMilliseconds = update.count();
        frame.repeats = i;
        frame.dropped = dropped;
        return frame;
    }
    return overflow(last);
}

}  // namespace lampyris::sandbox
