#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/overlay.h"

layout(set = 0, binding = SLOT_PANEL_FONT) uniform sampler2D font;
layout(set = 0, binding = SLOT_PANEL_PICTURE) uniform sampler2D picture;
layout(push_constant) uniform Push { PanelDraw drawn; };

layout(location = 0) in vec4 colour;
layout(location = 1) in vec2 uv;
layout(location = 0) out vec4 shown;

void main() {
    shown = colour * (drawn.samples == PANEL_SAMPLES_PICTURE ? textureLod(picture, uv, 0.0) : textureLod(font, uv, 0.0));
}
