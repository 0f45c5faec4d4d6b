// Direct light of all sphere lights that reach the tile, as in the Thesis: nothing hides a light. Diffuse irradiance
// (no albedo) and specular radiance.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/shade_direct.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant) uniform Push { DirectParams params; };

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (!insideImage(pixel)) return;
    float depth = depthAt(pixel);
    ShadedPixel p;
    p.irradiance = p.specular = vec3(0.0);
    if (depth > 0.0) {
        p = beginPixel(pixel, depth);
        for (uint word = 0u; word < params.maskWords; ++word) {
            uint left = masks[(p.tile * 2u) * params.maskWords + word];
            while (left != 0u) {
                uint i = word * 32u + uint(findLSB(left));
                if (gives(p, i)) addLight(p, i, 1.0);
                left &= left - 1u;
            }
        }
    }
    storePixel(pixel, p.irradiance, p.specular);
}
