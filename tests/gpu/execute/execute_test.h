/// \file A fixture with an executor, and short ways to run a frame.
#pragma once

#include "execute/executor.h"
#include "gpu/staging.h"
#include "gpu_test/shaders.h"
#include "graph/frame.h"
#include "support/gpu_test.h"

namespace lampyris::test {

class ExecuteTest : public GpuTest {
 protected:
    void SetUp() override {
        GpuTest::SetUp();
        if (IsSkipped()) return;
        executor_.emplace(need(execute::Executor::create(device())));
    }
    void TearDown() override {
        executor_.reset();
        GpuTest::TearDown();
    }
    execute::Executor& executor() { return *executor_; }

    /// Runs with the graph's own barriers alone: no timestamp stands between the nodes.
    execute::FrameResult run(const graph::Frame& frame, execute::RunOptions options = {}) {
        options.timed = false;
        return need(executor().run(frame, options));
    }
    template <typename T>
    gpu::Buffer makeBuffer(const std::vector<T>& values, const char* name = "values") {
        auto buffer =
            need(gpu::Buffer::create(device(), {.bytes = values.size() * sizeof(T), .name = name}));
        need(gpu::upload(device(), buffer, std::span<const T>{values}));
        return buffer;
    }
    static graph::Buffer import(graph::Frame& frame, const gpu::Buffer& buffer) {
        return frame.importBuffer(buffer.name(), {buffer.bytes()}, {&buffer},
                                  graph::Access::StorageRead);
    }

 private:
    std::optional<execute::Executor> executor_;
};

/// Push constants of doubled.comp.
struct DoublePush {
    uint32_t count;
    uint32_t add;
};

/// A node that doubles `source` into a new buffer.
inline graph::Buffer addDouble(graph::Frame& frame, const char* name, graph::Buffer source,
                               uint32_t count, uint32_t add = 0) {
    auto node = frame.compute(name, gpu_test::shaders::doubled);
    node.read(0, source).push(DoublePush{count, add});
    const graph::Buffer target =
        node.write(1, frame.buffer(std::string{name} + " out", {uint64_t{4} * count}));
    node.dispatch((count + 63) / 64);
    return target;
}

}  // namespace lampyris::test
