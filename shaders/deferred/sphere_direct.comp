// Direct light of all sphere lights that reach the tile: diffuse irradiance (no albedo) and specular radiance.
// UNSHADOWED: as the Thesis, without asking the shadow masks.
#version 460
#extension GL_GOOGLE_include_directive : require
#define SURFACE_MATERIAL
#include "lib/direct.glsl"
#include "lib/surface.glsl"
#include "shared/direct.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant) uniform Push { DirectParams params; };
layout(set = 0, binding = SLOT_LIGHTS, std430) readonly buffer Lights { GpuLight lights[]; };
layout(set = 0, binding = SLOT_LIGHT_REACH, std430) readonly buffer Reach { float reach[]; };
layout(set = 0, binding = SLOT_LIGHT_MASKS, std430) readonly buffer Masks { uint masks[]; };
#ifndef UNSHADOWED
layout(set = 0, binding = SLOT_SHADOW_MASKS, r32ui) uniform readonly uimage2DArray shadowMasks;
#endif
layout(set = 0, binding = SLOT_IRRADIANCE_DIRECT, rgba16f) uniform writeonly image2D irradianceDirect;
layout(set = 0, binding = SLOT_SPECULAR_DIRECT, rgba16f) uniform writeonly image2D specularDirect;

const vec3 kHalfMax = vec3(65504.0);

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (!insideImage(pixel)) return;
    vec3 irradiance = vec3(0.0), specular = vec3(0.0);
    float depth = depthAt(pixel);
    if (depth > 0.0) {
        vec3 position = positionWorld(pixel, depth);
        vec3 normal = normalAt(pixel);
        vec3 toEye = normalize(cameraWorld() - position);
        float roughness = texelFetch(surfaceAlbedo, pixel, 0).a;
        vec3 f0 = texelFetch(surfaceSpecular, pixel, 0).rgb;
        f0 *= f0;
        uint tile = (uint(pixel.y) / TILE_PIXELS) * view.tilesX + uint(pixel.x) / TILE_PIXELS;
        for (uint word = 0u; word < params.maskWords; ++word) {
            uint left = masks[(tile * 2u) * params.maskWords + word];
#ifndef UNSHADOWED
            left &= ~imageLoad(shadowMasks, ivec3(pixel, word)).r;
#endif
            while (left != 0u) {
                uint i = word * 32u + uint(findLSB(left));
                left &= left - 1u;
                vec3 toLight = lights[i].positionRadius.xyz - position;
                if (length(toLight) > reach[i]) continue;
                irradiance += diffuseIrradiance(lights[i], toLight, normal);
                if (any(greaterThan(f0, vec3(0.0))) && dot(normal, toLight) > 0.0)
                    specular += normalIrradiance(lights[i], toLight) *
                                sphereSpecular(normal, toEye, toLight, lights[i].positionRadius.w, roughness, f0);
            }
        }
    }
    imageStore(irradianceDirect, pixel, vec4(min(irradiance, kHalfMax), 1.0));
    imageStore(specularDirect, pixel, vec4(min(specular, kHalfMax), 1.0));
}
