// Radiance towards the camera: albedo/π · (direct + indirect irradiance) + specular + the surface's own glow, and
// in front of it the lights' discs. Where there is neither surface nor disc the image is exactly black.
#version 460
#extension GL_GOOGLE_include_directive : require
#define SURFACE_MATERIAL
#include "lib/sphere_light.glsl"
#include "lib/surface.glsl"
#include "shared/scene.h"
#include "shared/tile_bin.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant) uniform Push { GatherParams params; };
layout(set = 0, binding = SLOT_LIGHTS, std430) readonly buffer Lights { GpuLight lights[]; };
layout(set = 0, binding = SLOT_COMPOSITE_MASKS, std430) readonly buffer Masks { uint masks[]; };
layout(set = 0, binding = SLOT_COMPOSITE_DIRECT) uniform sampler2D irradianceDirect;
layout(set = 0, binding = SLOT_COMPOSITE_SPECULAR) uniform sampler2D specularDirect;
#ifdef WITH_INDIRECT
layout(set = 0, binding = SLOT_COMPOSITE_INDIRECT) uniform sampler2D irradianceIndirect;
#endif
layout(set = 0, binding = SLOT_COMPOSITE_OUT, rgba16f) uniform writeonly image2D radiance;

// Nearest light's disc along the pixel's ray, nearer than `limit`; radiance Φ/(4π²r²).
bool lightDisc(ivec2 pixel, float limit, out vec3 colour) {
    vec2 slope = slopes(vec2(pixel) + 0.5);
    vec3 ray = normalize(mat3(view.viewToWorld) * vec3(slope, -1.0));
    float nearest = limit * length(vec3(slope, 1.0));
    bool found = false;
    uint tile = (uint(pixel.y) / TILE_PIXELS) * view.tilesX + uint(pixel.x) / TILE_PIXELS;
    for (uint word = 0u; word < params.maskWords; ++word) {
        uint left = masks[(tile * 2u + 1u) * params.maskWords + word];
        while (left != 0u) {
            GpuLight light = lights[word * 32u + uint(findLSB(left))];
            left &= left - 1u;
            vec3 toLight = light.positionRadius.xyz - cameraWorld();
            float r = light.positionRadius.w;
            float b = dot(ray, toLight);
            float inside = b * b - dot(toLight, toLight) + r * r;
            float t = b - sqrt(max(inside, 0.0));
            if (inside < 0.0 || t <= 0.0 || t >= nearest) continue;
            nearest = t;
            found = true;
            float cone = coneFactor(dot(-ray, light.direction.xyz), light.direction.w, light.power.w);
            colour = light.power.rgb * (cone / (4.0 * kPi * kPi * r * r));
        }
    }
    return found;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (!insideImage(pixel)) return;
    float depth = depthAt(pixel);
    vec3 sum = vec3(0.0);
    if (depth > 0.0) {
        vec3 irradiance = texelFetch(irradianceDirect, pixel, 0).rgb;
#ifdef WITH_INDIRECT
        irradiance += texelFetch(irradianceIndirect, pixel, 0).rgb;
#endif
        sum = texelFetch(surfaceAlbedo, pixel, 0).rgb / kPi * irradiance + texelFetch(specularDirect, pixel, 0).rgb +
              unpackSharedExponent(texelFetch(surfaceEmission, pixel, 0).r);
    }
    vec3 disc;
    if (lightDisc(pixel, depth > 0.0 ? viewDepth(depth) : 1e30, disc)) sum = disc;
    imageStore(radiance, pixel, vec4(min(sum, vec3(65504.0)), 1.0));
}
