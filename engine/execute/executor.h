/// \file Runs compiled graphs on a device. Open this file first.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/image.h"
#include "core/result.h"
#include "execute/bindings.h"
#include "execute/frame_slot.h"
#include "execute/history_book.h"
#include "execute/memory_model.h"
#include "execute/pipelines.h"
#include "execute/raw_image.h"
#include "execute/resources.h"
#include "execute/statistics.h"
#include "execute/transients.h"
#include "graph/compile.h"

namespace lampyris::execute {

struct RunOptions {
    /// A device timestamp at every node's end. Nodes then run one after the other, as a full
    /// barrier stands before each stamp, except under validation: there the graph's own barriers
    /// stand alone and times overlap.
    bool timed = true;
    /// Read after the timed range, and after the wall time was taken. What is read must be an
    /// output of the frame, imported, or a history image.
    std::vector<graph::Image> readBackImages{};
    std::vector<graph::Buffer> readBackBuffers{};
};

struct FrameResult {
    FrameStatistics statistics;
    std::vector<RawImage> images;                 ///< as RunOptions::readBackImages; see toImage()
    std::vector<std::vector<std::byte>> buffers;  ///< as RunOptions::readBackBuffers
};

class Executor {
 public:
    /// The device must outlive the executor.
    static core::Result<Executor> create(gpu::Device& device);
    Executor(Executor&&) noexcept = default;
    Executor& operator=(Executor&&) = delete;
    ~Executor();

    /// For graph::CompileOptions::memory.
    [[nodiscard]] const graph::MemoryModel& memoryModel() const { return memoryModel_; }
    [[nodiscard]] gpu::Device& device() const { return *device_; }
    /// For Frame::history: `executor.history().known(name, desc)`.
    [[nodiscard]] HistoryBook& history() { return history_; }

    /// Runs one frame and waits for it. Errors name the node and the slot, limit or VkResult.
    core::Result<FrameResult> run(const graph::Frame& frame, const graph::CompiledGraph& graph,
                                  const RunOptions& options = {});
    /// Compiles with this device's sizes, then runs. What is to be read back is kept as an output.
    core::Result<FrameResult> run(const graph::Frame& frame, const RunOptions& options = {},
                                  graph::CompileOptions compileOptions = {});

    /// Submits one frame without waiting; then waits for the one before it, if there is one, and
    /// gives its cost. Imported host-visible buffers must not change until their frame is done.
    core::Result<std::optional<FrameStatistics>> runAhead(const graph::Frame& frame,
                                                          const graph::CompiledGraph& graph,
                                                          bool timed = true);
    /// Waits for all submitted frames; gives the last one's cost, if one was still running.
    core::Result<std::optional<FrameStatistics>> finish();

    /// Those that frames so far have run.
    [[nodiscard]] std::vector<const graph::Shader*> shaders() const { return pipelines_.shaders(); }
    /// Between two frames: waits for all that was submitted, then as Pipelines::replace().
    core::Result<void> replaceShader(const graph::Shader& shader, std::span<const uint32_t> words);

    /// The physical image of an output of the last frame, as it rests: TRANSFER_SRC for a
    /// transient. Good until the next run.
    [[nodiscard]] const gpu::Image& outputImage(graph::Image image) const;

 private:
    static constexpr size_t kFramesInFlight = 2;
    explicit Executor(gpu::Device& device);
    core::Result<void> prepare(const graph::Frame& frame, const graph::CompiledGraph& graph);
    core::Result<void> submitFrame(const graph::Frame& frame, const graph::CompiledGraph& graph,
                                   bool timed);
    core::Result<FrameStatistics> finishSlot(FrameSlot& slot);

    gpu::Device* device_;
    DeviceMemoryModel memoryModel_;
    Samplers samplers_;
    Pipelines pipelines_;
    Transients transients_;
    HistoryBook history_;
    Resources resources_;  ///< of the last frame
    std::vector<FrameSlot> slots_;
    size_t next_ = 0;  ///< the slot of the next frame
};

}  // namespace lampyris::execute
