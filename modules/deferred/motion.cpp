#include "deferred/motion.h"

#include <algorithm>
#include <iterator>

#include "deferred/shaders.h"
#include "shared/motion.h"
#include "shared/scene.h"

namespace lampyris::deferred {
namespace {

/// Equal depths alone: what the G-buffer cut out by alpha must not cover what it shows behind.
const graph::RasterPipeline& pipeline() {
    static const graph::RasterPipeline kPipeline{
        .vertex = &shaders::motionVert,
        .fragment = &shaders::motionFrag,
        .attributes = {{shared::STREAM_MOTION_POSITION, 0, 3, 16},
                       {shared::STREAM_MOTION_BEFORE, 1, 3, 16}},
        .depthWrite = false,
        .depthEqual = true};
    return kPipeline;
}

glm::vec4 row(const glm::mat4& m, int i) {
    return {m[0][i], m[1][i], m[2][i], m[3][i]};
}

void drawItem(graph::RasterCommands& commands, const residency::SceneHandles& scene,
              const residency::DrawItem& item) {
    graph::Draw draw;
    draw.pipeline = &pipeline();
    draw.streams = {scene.positions, item.reposed ? scene.positionsBefore : scene.positions};
    draw.streamOffsets = {item.positionOffsetBytes,
                          item.reposed ? item.positionBeforeOffsetBytes : item.positionOffsetBytes};
    draw.indices = scene.indices;
    draw.indexOffsetBytes = item.indexOffsetBytes;
    draw.count = item.indexCount;
    const glm::mat4& before = item.objectToWorldBefore;
    draw.pushConstants(
        shared::MotionDraw{row(before, 0), row(before, 1), row(before, 2), item.instance, 0, 0, 0});
    commands.draw(draw);
}

}  // namespace

graph::Image addMotion(graph::Frame& frame, const Surface& surface,
                       const residency::SceneHandles& scene,
                       const std::vector<residency::DrawItem>& draws) {
    std::vector<residency::DrawItem> moved;
    std::copy_if(draws.begin(), draws.end(), std::back_inserter(moved),
                 [](const auto& item) { return item.moved; });
    if (moved.empty()) return {};
    const graph::Extent size{surface.view.width, surface.view.height};
    auto node = frame.raster("gbuffer_motion", size);
    node.testDepth(surface.depth);
    const graph::Image motion = node.clearedColour(
        shared::TARGET_MOTION, frame.image("motion", {graph::Format::RGBA16Float, size}));
    node.vertices(scene.positions).indices(scene.indices);
    if (scene.positionsBefore.resource != scene.positions.resource)
        node.vertices(scene.positionsBefore);
    node.read(shared::SLOT_INSTANCES, scene.instances).uniformData(shared::SLOT_VIEW, surface.view);
    node.record({&shaders::motionVert, &shaders::motionFrag},
                [scene, items = std::move(moved)](graph::RasterCommands& commands) {
                    for (const auto& item : items) drawItem(commands, scene, item);
                });
    return motion;
}

}  // namespace lampyris::deferred
