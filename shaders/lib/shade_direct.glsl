// What the lights of a pixel's tile give it, one light after the other: the loop is the node's own, since each has
// its own way to know what a light is hidden by.
#ifndef LAMPYRIS_LIB_SHADE_DIRECT
#define LAMPYRIS_LIB_SHADE_DIRECT
#define SURFACE_MATERIAL
#ifndef LIGHT_ACCESS  // to what other nodes wrote
#define LIGHT_ACCESS writeonly
#endif
#include "lib/direct.glsl"
#include "lib/surface.glsl"
#include "shared/direct.h"

layout(set = 0, binding = SLOT_LIGHTS, std430) readonly buffer Lights { GpuLight lights[]; };
layout(set = 0, binding = SLOT_LIGHT_REACH, std430) readonly buffer Reach { float reach[]; };
layout(set = 0, binding = SLOT_LIGHT_MASKS, std430) readonly buffer Masks { uint masks[]; };
layout(set = 0, binding = SLOT_IRRADIANCE_DIRECT, rgba16f) uniform LIGHT_ACCESS image2D irradianceDirect;
layout(set = 0, binding = SLOT_SPECULAR_DIRECT, rgba16f) uniform LIGHT_ACCESS image2D specularDirect;

layout(constant_id = SPEC_ANY_SPECULAR) const uint kAnySpecular = 1u;

struct ShadedPixel {
    vec3 position, normal, toEye, f0;
    float roughness;
    uint tile;
    vec3 irradiance, specular;  // so far
};

ShadedPixel beginPixel(ivec2 pixel, float depth) {
    ShadedPixel p;
    p.position = positionWorld(pixel, depth);
    p.normal = normalAt(pixel);
    p.toEye = normalize(cameraWorld() - p.position);
    p.f0 = vec3(0.0);
    if (kAnySpecular != 0u) {
        p.roughness = texelFetch(surfaceAlbedo, pixel, 0).a;
        p.f0 = texelFetch(surfaceSpecular, pixel, 0).rgb;
        p.f0 *= p.f0;
    }
    p.tile = (uint(pixel.y) / TILE_PIXELS) * view.tilesX + uint(pixel.x) / TILE_PIXELS;
    p.irradiance = p.specular = vec3(0.0);
    return p;
}

// Whether the light gives the pixel something where nothing hides it.
bool gives(ShadedPixel p, uint i) {
    vec4 light = lights[i].positionRadius;
    vec3 toLight = light.xyz - p.position;
    return length(toLight) <= reach[i] && dot(toLight, p.normal) > -light.w;
}

// Of a light that gives something. seen: the share of it that nothing hides.
void addLight(inout ShadedPixel p, uint i, float seen) {
    GpuLight light = lights[i];
    vec3 toLight = light.positionRadius.xyz - p.position;
    p.irradiance += seen * diffuseIrradiance(light, toLight, p.normal);
    if (kAnySpecular != 0u && any(greaterThan(p.f0, vec3(0.0))) && dot(p.normal, toLight) > 0.0)
        p.specular += seen * normalIrradiance(light, toLight) *
                      sphereSpecular(p.normal, p.toEye, toLight, light.positionRadius.w, p.roughness, p.f0);
}

void storePixel(ivec2 pixel, vec3 irradiance, vec3 specular) {
    const vec3 kHalfMax = vec3(65504.0);
    imageStore(irradianceDirect, pixel, vec4(min(irradiance, kHalfMax), 1.0));
    imageStore(specularDirect, pixel, vec4(min(specular, kHalfMax), 1.0));
}

#endif
