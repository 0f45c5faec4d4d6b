/// \file One frame's view of the scene on the device, and the list of what to draw.
#pragma once

#include <cstdint>

#include "ecs/entity.h"
#include "graph/frame.h"
#include "math/glm.h"

namespace lampyris::residency {

/// The scene's buffers and images in one graph::Frame. All are there even for an empty scene.
struct SceneHandles {
    graph::Buffer instances;         ///< shared::GpuInstance, in the snapshot's order
    graph::Buffer materials;         ///< shared::GpuMaterial, in the snapshot's order
    graph::Buffer lights;            ///< shared::GpuLight, in the snapshot's order
    graph::Buffer emitters;          ///< shared::GpuEmitter
    graph::Buffer emitterTriangles;  ///< RGBA32Float texels, EMITTER_TEXELS a triangle
    graph::Buffer indices;    ///< uint32, also texels R32Uint; relative to the mesh's first vertex
    graph::Buffer positions;  ///< DevicePosition, object space, as posed in this frame
    graph::Buffer normals;    ///< 3 floats a vertex, as posed
    graph::Buffer positionsBefore;  ///< of reposed instances, as they were in the frame before
    graph::Buffer tangents;         ///< 4 floats a vertex, where a mesh has them
    graph::Buffer texcoords;        ///< 4 floats a vertex: both sets, where a mesh has them
    graph::Buffer colours;          ///< 4 floats a vertex, where a mesh has them
    graph::Image colourTextures;    ///< 2D array, RGBA8Srgb
    graph::Image dataTextures;      ///< 2D array, RGBA8Unorm
    uint32_t instanceCount = 0;
    uint32_t materialCount = 0;
    uint32_t lightCount = 0;
    uint32_t emitterCount = 0;
    bool anyMasked = false;    ///< an instance is alpha-masked
    bool anyTextures = false;  ///< a material has a texture
    bool anySpecular = false;  ///< a material is not Lambertian
    bool anyColours = false;   ///< a mesh has vertex colours
    bool anyEmission = false;  ///< an instance glows
};

/// One indexed draw of the raster nodes. Offsets are for Draw::streamOffsets; a stream that the
/// mesh lacks has offset 0 and is to be read with stride 0: each stream begins with one neutral
/// element.
struct DrawItem {
    uint32_t instance = 0;  ///< into SceneHandles::instances
    uint32_t material = 0;  ///< into SceneHandles::materials
    uint32_t indexCount = 0;
    uint64_t indexOffsetBytes = 0;
    uint64_t positionOffsetBytes = 0;
    uint64_t normalOffsetBytes = 0;
    uint64_t tangentOffsetBytes = 0;
    uint64_t texcoordOffsetBytes = 0;
    uint64_t colourOffsetBytes = 0;
    bool hasTangents = false;
    bool hasTexcoords = false;
    bool hasColours = false;
    bool textured = false;  ///< its material has a texture
    // What moved since the frame before: places or vertices. A new instance has not moved.
    bool moved = false;
    glm::mat4 objectToWorldBefore{1.0f};
    bool posed = false;                      ///< it has vertices of its own
    bool reposed = false;                    ///< and they moved; else they were where they are
    uint64_t positionBeforeOffsetBytes = 0;  ///< reposed: into SceneHandles::positionsBefore
};

/// A deformed instance of the last snapshot: its vertices are its own.
struct PosedInstance {
    uint32_t instance = 0;     ///< into the snapshot's instances
    ecs::Entity entity;        ///< tells it from frame to frame
    uint64_t meshVersion = 0;  ///< its triangles
    uint64_t poseVersion = 0;  ///< of its vertices in this frame
    uint32_t firstVertex = 0;  ///< of its range in positions and normals
    uint32_t firstIndex = 0;   ///< of its mesh in indices, whose numbers count from firstVertex
};

/// Binds what lib/scene_material.glsl reads: instances, materials, indices, texcoords, colours and
/// both texture arrays, each at its slot of shaders/shared/scene.h.
void bindMaterials(graph::ComputeNode& node, const SceneHandles& scene);

/// Binds what lib/emitter_table.glsl reads.
void bindEmitters(graph::ComputeNode& node, const SceneHandles& scene);

}  // namespace lampyris::residency
