// A photon a square of a few pixels.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "overlay/mark.glsl"

layout(location = 0) out vec3 colourOut;

void main() {
    const vec2 corners[6] = vec2[](vec2(-1, -1), vec2(1, -1), vec2(1, 1), vec2(-1, -1), vec2(1, 1), vec2(-1, 1));
    colourOut = vec3(0.0);
    gl_Position = NOWHERE;
    uint index = gl_InstanceIndex * stride();
    if (index >= photonCount()) return;
    PackedPhoton p = photons[index];
    colourOut = markColour(p);
    vec4 clip = marked(photonPosition(p.positionPower));
    clip.xy += corners[gl_VertexIndex] * (2.0 * params.radiusPixels * clip.w / vec2(params.width, params.height));
    gl_Position = clip;
}
