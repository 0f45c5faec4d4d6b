// Writes the surface under a pixel. Surfaces reflect on both sides, so normals are turned towards the camera.
// UNTEXTURED: for materials without textures, since lavapipe does not branch around a look-up that nobody wants.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/pack.glsl"
#include "shared/gbuffer.h"
#include "shared/scene.h"
#include "shared/view.h"

layout(set = 0, binding = SLOT_VIEW) uniform ViewBlock { View view; };
layout(set = 0, binding = SLOT_MATERIALS, std430) readonly buffer Materials { GpuMaterial materials[]; };
layout(push_constant) uniform Push { GBufferDraw drawn; };

layout(location = 0) in vec3 positionWorld;
layout(location = 1) in vec3 normalWorld;
layout(location = 2) in vec4 tangentWorld;
layout(location = 3) in vec4 texcoords;
layout(location = 4) in vec4 colour;

#ifdef UNTEXTURED
vec4 colourTexel(uint use) { return vec4(1.0); }
vec4 dataTexel(uint use, vec4 absent) { return absent; }
#else
#include "lib/texture_lookup.glsl"
layout(set = 0, binding = SLOT_COLOUR_TEXTURES) uniform sampler2DArray colourTextures;
layout(set = 0, binding = SLOT_DATA_TEXTURES) uniform sampler2DArray dataTextures;
vec4 colourTexel(uint use) { return lookUpTexture(colourTextures, use, texcoords, vec4(1.0)); }
vec4 dataTexel(uint use, vec4 absent) { return lookUpTexture(dataTextures, use, texcoords, absent); }
#endif

layout(location = TARGET_NORMAL) out uint normalOut;
layout(location = TARGET_ALBEDO) out vec4 albedoOut;
layout(location = TARGET_SPECULAR) out vec4 specularOut;
layout(location = TARGET_EMISSION) out uint emissionOut;

vec3 mappedNormal(GpuMaterial material, vec3 n) {
    if (material.normalTexture == SCENE_NONE || drawn.hasTangents == 0u) return n;
    vec3 texel = dataTexel(material.normalTexture, vec4(0.5, 0.5, 1.0, 1.0)).xyz * 2.0 - 1.0;
    vec3 t = tangentWorld.xyz - n * dot(n, tangentWorld.xyz);
    if (dot(t, t) < 1e-12) return n;
    t = normalize(t);
    vec3 b = cross(n, t) * tangentWorld.w;
    return normalize(texel.x * material.normalScale * t + texel.y * material.normalScale * b + texel.z * n);
}

void main() {
    GpuMaterial material = materials[drawn.material];
    vec4 base = material.baseColour * colour * colourTexel(material.baseColourTexture);
    if ((material.flags & MATERIAL_MASKED) != 0u && base.a < material.alphaCutoff) discard;

    vec4 packed = dataTexel(material.metallicRoughnessTexture, vec4(1.0));
    float roughness = material.roughness * packed.g, metallic = material.metallic * packed.b;
    vec3 geometric = normalize(cross(dFdx(positionWorld), dFdy(positionWorld)));
    vec3 toEye = view.viewToWorld[3].xyz - positionWorld;
    if (dot(geometric, toEye) < 0.0) geometric = -geometric;
    vec3 interpolated = normalize(normalWorld);
    bool back = dot(interpolated, geometric) < 0.0;
    vec3 normal = mappedNormal(material, interpolated);
    normalOut = packDirection(back ? -normal : normal);

    albedoOut = vec4(base.rgb * (1.0 - metallic), roughness);
    vec3 dielectric = min(0.04 * material.specular.rgb, vec3(1.0)) * material.specular.w;
    specularOut = vec4(sqrt(mix(dielectric, base.rgb, metallic)), 1.0);

    vec3 emission = vec3(0.0);
    if ((material.flags & MATERIAL_EMISSIVE) != 0u && (!back || (material.flags & MATERIAL_DOUBLE_SIDED) != 0u)) {
        emission = material.emissiveRadiance.rgb * colourTexel(material.emissiveTexture).rgb;
    }
    emissionOut = packSharedExponent(emission);
}
