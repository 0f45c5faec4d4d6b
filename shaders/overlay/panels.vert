// Panels: triangles in pixels, pulled from this frame's lists.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/overlay.h"

layout(set = 0, binding = SLOT_PANEL_VERTICES, std430) readonly buffer Vertices { uint words[]; };
layout(set = 0, binding = SLOT_PANEL_INDICES, std430) readonly buffer Indices { uint indices[]; };
layout(push_constant) uniform Push { PanelDraw drawn; };

layout(location = 0) out vec4 colourOut;
layout(location = 1) out vec2 uvOut;

void main() {
    uint first = PANEL_VERTEX_WORDS * (drawn.firstVertex + indices[drawn.firstIndex + gl_VertexIndex]);
    vec2 position = uintBitsToFloat(uvec2(words[first], words[first + 1]));
    uvOut = uintBitsToFloat(uvec2(words[first + 2], words[first + 3]));
    colourOut = unpackUnorm4x8(words[first + 4]);
    gl_Position = vec4(position * drawn.scale + drawn.offset, 0.0, 1.0);
}
