#include "deferred/gbuffer.h"

#include <array>
#include <memory>

#include "deferred/shaders.h"
#include "shared/gbuffer.h"
#include "shared/scene.h"
#include "shared/surface.h"

namespace lampyris::deferred {
namespace {

using shared::GBufferDraw;

/// Pipelines for every combination of attributes that a mesh may lack (a missing one has stride 0),
/// and for materials without textures.
struct GBufferPipelines {
    std::array<graph::RasterPipeline, 16> byAttributes;

    GBufferPipelines() {
        for (uint32_t bits = 0; bits < byAttributes.size(); ++bits) {
            const auto optionalStride = [bits](uint32_t bit) {
                return (bits & bit) != 0 ? 16u : 0u;
            };
            byAttributes[bits] = {
                .vertex = &shaders::gbufferVert,
                .fragment =
                    (bits & 8) != 0 ? &shaders::gbufferFrag : &shaders::gbufferUntexturedFrag,
                .attributes = {{shared::STREAM_POSITION, 0, 3, 16},
                               {shared::STREAM_NORMAL, 1, 3, 12},
                               {shared::STREAM_TANGENT, 2, 4, optionalStride(1)},
                               {shared::STREAM_TEXCOORDS, 3, 4, optionalStride(2)},
                               {shared::STREAM_COLOUR, 4, 4, optionalStride(4)}}};
        }
    }
};

const graph::RasterPipeline& pipelineFor(const residency::DrawItem& item) {
    static const GBufferPipelines pipelines;
    return pipelines.byAttributes[(item.hasTangents ? 1u : 0u) | (item.hasTexcoords ? 2u : 0u) |
                                  (item.hasColours ? 4u : 0u) | (item.textured ? 8u : 0u)];
}

void drawItem(graph::RasterCommands& commands, const residency::SceneHandles& scene,
              const residency::DrawItem& item) {
    graph::Draw draw;
    draw.pipeline = &pipelineFor(item);
    draw.streams = {scene.positions, scene.normals, scene.tangents, scene.texcoords, scene.colours};
    draw.streamOffsets = {item.positionOffsetBytes, item.normalOffsetBytes, item.tangentOffsetBytes,
                          item.texcoordOffsetBytes, item.colourOffsetBytes};
    draw.indices = scene.indices;
    draw.indexOffsetBytes = item.indexOffsetBytes;
    draw.count = item.indexCount;
    draw.pushConstants(GBufferDraw{item.instance, item.material, item.hasTangents ? 1u : 0u, 0u});
    commands.draw(draw);
}

/// All images of a surface, by name and format.
template <typename ImageOf>
Surface surfaceOf(const shared::View& view, const ImageOf& imageOf) {
    return {.depth = imageOf("depth buffer", graph::Format::D32Float),
            .normal = imageOf("packed normal", graph::Format::R32Uint),
            .albedo = imageOf("albedo and roughness", graph::Format::RGBA16Float),
            .specular = imageOf("reflectance", graph::Format::RGBA8Unorm),
            .emission = imageOf("packed emission", graph::Format::R32Uint),
            .view = view};
}

}  // namespace

Surface recallGBuffer(graph::Frame& frame, const shared::View& view) {
    return surfaceOf(view, [&](const char* name, graph::Format format) {
        return kept(frame, name, {format, {view.width, view.height}});
    });
}

Surface addGBuffer(graph::Frame& frame, const shared::View& view,
                   const residency::SceneHandles& scene,
                   const std::vector<residency::DrawItem>& draws, Keep keep) {
    const graph::Extent size{view.width, view.height};
    Surface surface = surfaceOf(view, [&](const char* name, graph::Format format) {
        return keepable(frame, keep, name, {format, size});
    });
    auto node = frame.raster("gbuffer", size);
    surface.depth = node.clearedDepth(surface.depth);
    surface.normal = node.clearedColourUint(shared::TARGET_NORMAL, surface.normal);
    surface.albedo = node.clearedColour(shared::TARGET_ALBEDO, surface.albedo);
    surface.specular = node.clearedColour(shared::TARGET_SPECULAR, surface.specular);
    surface.emission = node.clearedColourUint(shared::TARGET_EMISSION, surface.emission);
    node.vertices(scene.positions).vertices(scene.normals).vertices(scene.tangents);
    node.vertices(scene.texcoords).vertices(scene.colours).indices(scene.indices);
    node.read(shared::SLOT_INSTANCES, scene.instances)
        .read(shared::SLOT_MATERIALS, scene.materials)
        .sample(shared::SLOT_COLOUR_TEXTURES, scene.colourTextures, graph::Filtering::Linear,
                graph::Addressing::Repeat)
        .sample(shared::SLOT_DATA_TEXTURES, scene.dataTextures, graph::Filtering::Linear,
                graph::Addressing::Repeat)
        .uniformData(shared::SLOT_VIEW, view);
    node.record({&shaders::gbufferVert, &shaders::gbufferFrag, &shaders::gbufferUntexturedFrag},
                [scene, items = draws](graph::RasterCommands& commands) {
                    for (const auto& item : items) drawItem(commands, scene, item);
                });
    return surface;
}

void bindSurface(graph::ComputeNode& node, const Surface& surface) {
    node.sample(shared::SLOT_SURFACE_DEPTH, surface.depth)
        .sample(shared::SLOT_SURFACE_NORMAL, surface.normal)
        .uniformData(shared::SLOT_VIEW, surface.view);
}

void bindSurfaceMaterial(graph::ComputeNode& node, const Surface& surface) {
    bindSurface(node, surface);
    node.sample(shared::SLOT_SURFACE_ALBEDO, surface.albedo)
        .sample(shared::SLOT_SURFACE_SPECULAR, surface.specular)
        .sample(shared::SLOT_SURFACE_EMISSION, surface.emission);
}

}  // namespace lampyris::deferred
