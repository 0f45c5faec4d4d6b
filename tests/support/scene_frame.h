/// \file A scene on the device and a frame that begins with it, for tests of single nodes.
#pragma once

#include <vector>

#include "accel/accel_on_gpu.h"
#include "execute/executor.h"
#include "residency/scene_on_gpu.h"
#include "shared/photon.h"
#include "support/gpu_test.h"

namespace lampyris::test {

struct SceneFrame {
    execute::Executor executor;
    residency::SceneOnGpu scene;
    accel::AccelOnGpu accel;
    graph::Frame frame;
    residency::SceneHandles handles;
    accel::AccelHandles tree;
    graph::Buffer counters{};  ///< shared::FrameCounters, all 0

    SceneFrame(gpu::Device& device, const scene::SceneSnapshot& snapshot)
        : executor(need(execute::Executor::create(device))), scene(device), accel(scene) {
        need(scene.update(snapshot));
        need(accel.update(snapshot));
        handles = residency::importScene(frame, scene);
        tree = accel::importAccel(frame, accel, handles);
        auto clear = frame.transfer("clear");
        counters = clear.fill(frame.buffer("counters", {sizeof(shared::FrameCounters)}), 0);
    }

    /// Runs the frame and reads those back.
    auto run(const std::vector<graph::Buffer>& buffers,
             const std::vector<graph::Image>& images = {}) {
        execute::RunOptions options;
        options.readBackBuffers = buffers;
        options.readBackImages = images;
        for (const auto image : images) frame.output(image);
        for (const auto buffer : buffers) frame.output(buffer);
        return need(executor.run(frame, options));
    }
};

}  // namespace lampyris::test
