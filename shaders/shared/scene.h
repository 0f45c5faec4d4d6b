// The scene as shaders see it: instances, materials, lights, emitters. Written by modules/residency.
#ifndef LAMPYRIS_SHARED_SCENE_H
#define LAMPYRIS_SHARED_SCENE_H

#include "shared/glsl_compat.h"

LAMPYRIS_SHARED_BEGIN

// Slots 16 to 31 belong to the scene and the BVH (see bvh.h); 0 to 15 to the node itself.
LAMPYRIS_SLOT(SLOT_INSTANCES, 19u);         // storage buffer of GpuInstance
LAMPYRIS_SLOT(SLOT_MATERIALS, 20u);         // storage buffer of GpuMaterial
LAMPYRIS_SLOT(SLOT_INDICES, 21u);           // texels R32Uint: three vertices a triangle
LAMPYRIS_SLOT(SLOT_TEXCOORDS, 22u);         // texels RGBA32Float: both sets a vertex
LAMPYRIS_SLOT(SLOT_COLOURS, 23u);           // texels RGBA32Float: linear RGBA a vertex
LAMPYRIS_SLOT(SLOT_COLOUR_TEXTURES, 24u);   // sampler2DArray, sRGB: base colour, emissive
LAMPYRIS_SLOT(SLOT_DATA_TEXTURES, 25u);     // sampler2DArray, linear: normal, metallic-roughness
LAMPYRIS_SLOT(SLOT_LIGHTS, 26u);            // storage buffer of GpuLight
LAMPYRIS_SLOT(SLOT_EMITTERS, 27u);          // storage buffer of GpuEmitter
LAMPYRIS_SLOT(SLOT_EMITTER_TRIANGLES, 28u); // texels RGBA32Float: EMITTER_TEXELS a triangle

// Specialization constants of lib/scene_material.glsl: 0 where the scene has none, so that looking costs nothing.
LAMPYRIS_SLOT(SPEC_SCENE_TEXTURES, 24u);
LAMPYRIS_SLOT(SPEC_SCENE_COLOURS, 25u);
LAMPYRIS_SLOT(SPEC_SCENE_EMISSION, 26u);

// Says that an instance has no such attribute, a material no such texture.
LAMPYRIS_SLOT(SCENE_NONE, 0xffffffffu);

// GpuInstance.flags
LAMPYRIS_SLOT(INSTANCE_MASKED, 1u);        // alpha MASK: cut out for every ray
LAMPYRIS_SLOT(INSTANCE_EMISSIVE, 2u);
LAMPYRIS_SLOT(INSTANCE_IDENTITY, 4u);      // objectToWorld is the identity
LAMPYRIS_SLOT(INSTANCE_MIRRORED, 8u);      // objectToWorld has a negative determinant
LAMPYRIS_SLOT(INSTANCE_DOUBLE_SIDED, 16u); // emits on both sides

struct GpuInstance {
    vec4 objectToWorld0, objectToWorld1, objectToWorld2;  // rows: world.x = dot(row0, vec4(object, 1))
    vec4 worldToObject0, worldToObject1, worldToObject2;  // rows
    uint material;       // into the materials
    uint flags;          // INSTANCE_…
    uint firstIndex;     // of the mesh, into the indices
    uint firstVertex;    // of the mesh, or of the posed instance, into positions and normals
    uint firstTexcoord;  // the mesh's first vertex in the texcoord stream, or SCENE_NONE
    uint firstColour;    // … in the colour stream, or SCENE_NONE
    uint firstTangent;   // of the mesh, or of the posed instance, in the tangent stream, or SCENE_NONE
    uint entity;         // ecs::Entity bits
};

// GpuMaterial.flags
LAMPYRIS_SLOT(MATERIAL_MASKED, 1u);
LAMPYRIS_SLOT(MATERIAL_DOUBLE_SIDED, 2u);
LAMPYRIS_SLOT(MATERIAL_EMISSIVE, 4u);

// A texture as a material uses it, one uint: bits 0–15 the layer, then the fields below; or SCENE_NONE.
LAMPYRIS_SLOT(TEXTURE_LAYER_MASK, 0xffffu);
LAMPYRIS_SLOT(TEXTURE_CLAMP_U, 0x10000u);
LAMPYRIS_SLOT(TEXTURE_MIRROR_U, 0x20000u);
LAMPYRIS_SLOT(TEXTURE_CLAMP_V, 0x40000u);
LAMPYRIS_SLOT(TEXTURE_MIRROR_V, 0x80000u);
LAMPYRIS_SLOT(TEXTURE_NEAREST, 0x100000u);
LAMPYRIS_SLOT(TEXTURE_SECOND_SET, 0x200000u);

struct GpuMaterial {
    vec4 baseColour;        // linear RGBA
    vec4 emissiveRadiance;  // rgb in W/(m² sr), before the texture; w unused
    vec4 specular;          // rgb colour, w factor (0 is Lambertian)
    float metallic;
    float roughness;
    float normalScale;
    float alphaCutoff;
    uint baseColourTexture;         // into the colour textures
    uint metallicRoughnessTexture;  // into the data textures: roughness in G, metallic in B
    uint emissiveTexture;           // into the colour textures
    uint normalTexture;             // into the data textures
    uint flags;                     // MATERIAL_…
    uint pad0, pad1, pad2;
};

struct GpuLight {
    vec4 positionRadius;  // metres, world
    vec4 power;           // rgb in W over the whole sphere; w = cosine of the outer cone, −1 without one
    vec4 direction;       // xyz unit, world; w = cosine of the inner cone
};

// An instance that glows. Its triangles stand in world space in the emitter triangles, front side = cross(e1, e2).
struct GpuEmitter {
    vec4 power;          // rgb in W, all triangles and both sides where it has two; w = mean of rgb
    uint instance;
    uint firstTriangle;  // into the emitter triangles
    uint triangleCount;
    uint flags;          // INSTANCE_…
};

// A triangle of an emitter: (v0, primitive as bits) (e1, cumulative share of its emitter's power, the last is 1) (e2, area m²)
// (mean radiance rgb, cumulative share of all emitters' power, the last is 1)
LAMPYRIS_SLOT(EMITTER_TEXELS, 4u);

LAMPYRIS_SHARED_END

#endif
