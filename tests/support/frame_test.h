/// \file A fixture that draws whole frames of small scenes, under validation.
#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "ecs/world.h"
#include "execute/executor.h"
#include "photon_gi/renderer.h"
#include "scene/builtin/builtin.h"
#include "scene/extract.h"
#include "support/gpu_test.h"
#include "support/small_scenes.h"

namespace lampyris::test {

struct Rendered {
    core::Image image;
    photon_gi::FrameReport report;
    execute::FrameStatistics statistics;
};

struct OwnExecutor {
    execute::Executor executor;
};

inline scene::SceneSnapshot builtinSnapshot(std::string_view name) {
    const ecs::World world = need(scene::builtinScene(name));
    return scene::extract(world, {}, 0);
}

/// A renderer that has taken in a scene.
class SceneRenderer : private OwnExecutor, public photon_gi::Renderer {
 public:
    SceneRenderer(gpu::Device& device, const scene::SceneSnapshot& snapshot)
        : OwnExecutor{need(execute::Executor::create(device))}, Renderer(executor) {
        need(update(snapshot));
    }
};

class FrameTest : public GpuTest {
 protected:
    /// Draws until no buffer is too small, as the program does.
    static Rendered render(const scene::SceneSnapshot& snapshot, photon_gi::FrameRequest request,
                           const std::string& outputNode) {
        SceneRenderer renderer(device(), snapshot);
        return render(renderer, request, outputNode);
    }

    static Rendered render(photon_gi::Renderer& renderer, const photon_gi::FrameRequest& request,
                           const std::string& outputNode,
                           const graph::CompileOptions& options = {}) {
        for (int attempt = 0; attempt < 8; ++attempt) {
            graph::Frame frame;
            const auto drawn = test::need(renderer.declare(frame, request));
            auto outcome = need(renderer.run(frame, drawn, outputNode, options));
            if (outcome.report.valid)
                return {std::move(outcome.image), outcome.report, std::move(outcome.statistics)};
        }
        throw std::runtime_error("the frame overflowed eight times");
    }

    static photon_gi::FrameRequest request(uint32_t width, uint32_t height,
                                           const scene::SnapshotCamera& camera) {
        photon_gi::FrameRequest made;
        made.size = {width, height};
        made.camera = camera;
        made.settings.lightCutoff = 0.0f;
        made.settings.history = 0;
        return made;
    }
};

}  // namespace lampyris::test
