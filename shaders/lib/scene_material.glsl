// What the surface is like where a ray hits it. C++ binds the slots with residency::bindMaterials.
#ifndef LAMPYRIS_LIB_SCENE_MATERIAL
#define LAMPYRIS_LIB_SCENE_MATERIAL
#include "lib/texture_lookup.glsl"
#include "shared/scene.h"

layout(constant_id = SPEC_SCENE_TEXTURES) const uint sceneTextures = 1u;
layout(constant_id = SPEC_SCENE_COLOURS) const uint sceneColours = 1u;
layout(constant_id = SPEC_SCENE_EMISSION) const uint sceneEmission = 1u;
layout(set = 0, binding = SLOT_INSTANCES, std430) readonly buffer Instances { GpuInstance instances[]; };
layout(set = 0, binding = SLOT_MATERIALS, std430) readonly buffer Materials { GpuMaterial materials[]; };
layout(set = 0, binding = SLOT_INDICES) uniform usamplerBuffer meshIndices;
layout(set = 0, binding = SLOT_TEXCOORDS) uniform samplerBuffer meshTexcoords;
layout(set = 0, binding = SLOT_COLOURS) uniform samplerBuffer meshColours;
layout(set = 0, binding = SLOT_COLOUR_TEXTURES) uniform sampler2DArray colourTextures;
layout(set = 0, binding = SLOT_DATA_TEXTURES) uniform sampler2DArray dataTextures;

struct Hit {
    float t;           // in lengths of the ray's direction
    uint instance;
    uint primitive;    // the triangle's place in its mesh
    vec2 bary;         // weights of the second and third corner
    vec3 normalWorld;  // geometric, unit, to the front side: may point away from the ray's origin
};

vec4 cornerMix(samplerBuffer stream, uint first, uint firstIndex, uint primitive, vec2 bary) {
    int corner = int(firstIndex + 3u * primitive);
    vec4 a = texelFetch(stream, int(first + texelFetch(meshIndices, corner).x));
    vec4 b = texelFetch(stream, int(first + texelFetch(meshIndices, corner + 1).x));
    vec4 c = texelFetch(stream, int(first + texelFetch(meshIndices, corner + 2).x));
    return a * (1.0 - bary.x - bary.y) + b * bary.x + c * bary.y;
}

// Both sets of texture coordinates.
vec4 texcoordsAt(uint instance, uint primitive, vec2 bary) {
    uint first = instances[instance].firstTexcoord;
    if (first == SCENE_NONE) return vec4(0.0);
    return cornerMix(meshTexcoords, first, instances[instance].firstIndex, primitive, bary);
}

// Base colour factor · vertex colour · texture, linear RGBA.
vec4 baseColourAt(uint instance, uint primitive, vec2 bary) {
    uint material = instances[instance].material;
    vec4 colour = materials[material].baseColour;
    uint firstColour = instances[instance].firstColour;
    if (sceneColours != 0u && firstColour != SCENE_NONE)
        colour *= cornerMix(meshColours, firstColour, instances[instance].firstIndex, primitive, bary);
    uint use = materials[material].baseColourTexture;
    if (sceneTextures != 0u && use != SCENE_NONE)
        colour *= lookUpTexture(colourTextures, use, texcoordsAt(instance, primitive, bary), vec4(1.0));
    return colour;
}

// False where alpha MASK cuts the surface out.
bool opaqueAt(uint instance, uint primitive, vec2 bary) {
    uint material = instances[instance].material;
    if ((materials[material].flags & MATERIAL_MASKED) == 0u) return true;
    return baseColourAt(instance, primitive, bary).a >= materials[material].alphaCutoff;
}

// Radiance that the surface sends back along the ray: glowing materials do so from the front, or from both sides.
vec3 hitEmission(Hit hit, vec3 direction) {
    uint material = instances[hit.instance].material;
    uint flags = materials[material].flags;
    bool back = dot(hit.normalWorld, direction) > 0.0;
    if ((flags & MATERIAL_EMISSIVE) == 0u || (back && (flags & MATERIAL_DOUBLE_SIDED) == 0u)) return vec3(0.0);
    vec3 radiance = materials[material].emissiveRadiance.rgb;
    uint use = materials[material].emissiveTexture;
    if (sceneTextures != 0u && use != SCENE_NONE)
        radiance *= lookUpTexture(colourTextures, use, texcoordsAt(hit.instance, hit.primitive, hit.bary), vec4(1.0)).rgb;
    return radiance;
}

// What a Lambertian bounce keeps: base colour · (1 − metallic).
vec3 hitAlbedo(Hit hit) {
    uint material = instances[hit.instance].material;
    float metallic = materials[material].metallic;
    uint use = materials[material].metallicRoughnessTexture;
    if (sceneTextures != 0u && metallic > 0.0 && use != SCENE_NONE)
        metallic *= lookUpTexture(dataTextures, use, texcoordsAt(hit.instance, hit.primitive, hit.bary), vec4(1.0)).b;
    return baseColourAt(hit.instance, hit.primitive, hit.bary).rgb * (1.0 - metallic);
}

#endif
