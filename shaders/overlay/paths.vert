// A line from each photon to the next of its path: an instance a path, two vertices a line.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "overlay/mark.glsl"

layout(location = 0) out vec3 colourOut;

void main() {
    colourOut = vec3(0.0);
    gl_Position = NOWHERE;
    uint path = gl_InstanceIndex * stride();
    if (path >= params.pathCount) return;
    uint first = pathOffsets[path] + uint(gl_VertexIndex) / 2u;
    if (first + 1u >= min(pathOffsets[path + 1u], photonCount())) return;
    PackedPhoton p = photons[first + (uint(gl_VertexIndex) & 1u)];
    colourOut = markColour(p);
    gl_Position = marked(photonPosition(p.positionPower));
}
