// Direct light of the listed pixels by their own shadow rays, over what was interpolated there.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/indirect_groups.glsl"
#include "lib/shade_direct.glsl"
#include "lib/shadow_rays.glsl"

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { DirectParams params; };
layout(set = 0, binding = SLOT_SHADOW_LIST, std430) readonly buffer List { uint list[]; };
layout(set = 0, binding = SLOT_SHADOW_LISTED, std430) readonly buffer Listed { uint listed; };

void main() {
    uint place = threadInRows();
    if (place >= listed) return;
    ivec2 pixel = ivec2(list[place] & 0xffffu, list[place] >> 16);
    float depth = depthAt(pixel);
    ShadedPixel p = beginPixel(pixel, depth);
    vec3 origin = clearOf(p.position, p.normal, viewDepth(depth));
    uvec2 random = seedRandom(uint(pixel.y) * view.width + uint(pixel.x), params.seed ^ 0x9e3779b9u);
    for (uint word = 0u; word < params.maskWords; ++word) {
        uint left = masks[(p.tile * 2u) * params.maskWords + word];
        while (left != 0u) {
            uint i = word * 32u + uint(findLSB(left));
            left &= left - 1u;
            uint seen = raysThatSee(lights[i], origin, p.normal, params.rays, random2(random), random);
            addLight(p, i, float(seen) / float(params.rays));
        }
    }
    storePixel(pixel, p.irradiance, p.specular);
}
