#version 460
layout(location = 0) in vec3 colour;
layout(location = 0) out vec4 shown;

void main() { shown = vec4(colour, 0.85); }
