// A line from each photon to the next of its path.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "overlay/mark.glsl"

layout(location = 0) out vec3 colourOut;

void main() {
    colourOut = vec3(0.0);
    gl_Position = NOWHERE;
    uint first = gl_InstanceIndex;
    if (first + 1u >= photonCount()) return;
    // Photons lie in the order (path, bounce): a next one of a higher bounce is of the same path.
    if (bounceOf(photons[first + 1u]) <= bounceOf(photons[first])) return;
    PackedPhoton p = photons[first + uint(gl_VertexIndex)];
    colourOut = markColour(p);
    gl_Position = marked(photonPosition(p.positionPower));
}
