// Adds to the listed pixels the lights that are left, by shadow rays of their own.
#version 460
#extension GL_GOOGLE_include_directive : require
#define LIGHT_ACCESS
#include "lib/indirect_groups.glsl"
#include "lib/shade_direct.glsl"
#include "lib/shadow_rays.glsl"

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { DirectParams params; };
layout(set = 0, binding = SLOT_SHADOW_LIST, std430) readonly buffer List { uvec2 list[]; };
layout(set = 0, binding = SLOT_SHADOW_LISTED, std430) readonly buffer Listed { uint listed; };

// Half of the rays speak for all where they agree. That saves a third of this node's time in the courtyard, and is
// biased towards all or nothing at a penumbra's ends: a tenth more error.
void main() {
    uint place = threadInRows();
    if (place >= listed) return;
    ivec2 pixel = ivec2(list[place].x & 0xffffu, list[place].x >> 16);
    float depth = depthAt(pixel);
    ShadedPixel p = beginPixel(pixel, depth);
    vec3 origin = clearOf(p.position, p.normal, viewDepth(depth));
    uint number = uint(pixel.y) * view.width + uint(pixel.x);
    uint enough = params.rays < 4u ? params.rays : (params.rays + 1u) / 2u;
    for (uint word = 0u; word < params.maskWords; ++word) {
        uint left = masks[(p.tile * 2u) * params.maskWords + word];
        if (params.maskWords == 1u) left &= list[place].y;
        while (left != 0u) {
            uint i = word * 32u + uint(findLSB(left));
            left &= left - 1u;
            if (!gives(p, i)) continue;
            // A light's points are its own, whichever others are left.
            uvec2 random = seedRandom(number, params.seed ^ ((i + 1u) * 0x9e3779b9u));
            uint seen = raysThatSee(lights[i], origin, p.normal, params.rays, enough, random2(random), random);
            addLight(p, i, float(seen) / float(params.rays));
        }
    }
    storePixel(pixel, p.irradiance + imageLoad(irradianceDirect, pixel).rgb,
               p.specular + imageLoad(specularDirect, pixel).rgb);
}
